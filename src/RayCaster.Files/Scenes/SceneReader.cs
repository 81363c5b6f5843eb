namespace RayCaster.Files;

/// <summary>Reads a scene from a scene file (docs/scene-file.md), or reports all its mistakes.</summary>
public static class SceneReader
{
    /// <summary>The longest scene file, in bytes: some 400,000 models. More triangles belong in a mesh file.</summary>
    internal const int MaxBytes = 1 << 26;

    internal const int MaxShortBytes = 1 << 20;

    private const string Root = "the scene", TooLong = "; put large meshes into mesh files";

    internal static IReadOnlyList<string> ModelTypes => PrimitiveList.Names;

    /// <summary>Reads a file. A file that cannot be read is a problem without a line.</summary>
    /// <param name="path">The file; messages name it as it is given here.</param>
    public static SceneReading Read(string path)
    {
        if (MeshFile.IsNamedLikeOne(path) && File.Exists(path)) return Unreadable(path, "this is a mesh; name it in a scene, and draw the scene");
        return Read(path, Path.GetDirectoryName(path) ?? "", () => InputFile.Read(path, "scene file", MaxBytes, TooLong), Root, ReadScene, out _);
    }

    /// <summary>Reads the rest of a stream, which may be a pipe that never ends.</summary>
    /// <inheritdoc cref="Parse"/>
    /// <exception cref="IOException">The stream fails.</exception>
    public static SceneReading Read(Stream stream, string displayName, string folder) =>
        Read(displayName, folder, () => InputFile.ReadToEnd(stream, "scene file", MaxBytes, TooLong), Root, ReadScene, out _);

    /// <summary>Reads a text.</summary>
    /// <param name="utf8">The text, with or without a byte order mark.</param>
    /// <param name="displayName">Its name in messages; <c>&lt;stdin&gt;</c> for standard input.</param>
    /// <param name="folder">The folder where paths of mesh files start.</param>
    public static SceneReading Parse(ReadOnlyMemory<byte> utf8, string displayName, string folder) =>
        Read(displayName, folder, () => utf8, Root, ReadScene, out _);

    /// <summary>Reads a short file in the form of a scene file. Returns null if there is an error.</summary>
    /// <param name="name">The name of the outermost object in messages.</param>
    internal static T? ReadShort<T>(string path, string name, Func<JsonKeys, T?> read, out SceneReading reading) where T : class
    {
        reading = Read(path, "", () => InputFile.Read(path, "file", MaxShortBytes), name, read, out var result);
        return result;
    }

    private static SceneReading Read<T>(
        string displayName, string folder, Func<ReadOnlyMemory<byte>> open, string name, Func<JsonKeys, T?> read, out T? result) where T : class
    {
        result = null;
        SceneReading reading;
        try
        {
            reading = new(displayName, open(), folder);
        }
        catch (ProblemException e)
        {
            return Unreadable(displayName, e.Message);
        }
        var tree = JsonTree.Parse(reading, key => TakesText(key, read));
        var found = tree is not null && JsonKeys.AsObject(tree.Root, name) is { } root ? read(root) : null;
        reading.End();
        if (reading.ErrorCount == 0) result = found;
        reading.Scene = result as Scene;
        return reading;
    }

    /// <summary>Whether a key of a file, or of a model, may have a text as its value.</summary>
    private static bool TakesText<T>(string key, Func<JsonKeys, T?> read)
    {
        read(JsonKeys.Describing(out var keys));
        return key == "type" || keys.Concat(keys.SelectMany(outer => outer.Members)).Concat(PrimitiveList.KeysOfAllTypes).Any(known =>
            known.Name == key && known.Kind is KeyKind.Text or KeyKind.Texts or KeyKind.FileName or KeyKind.Choice or KeyKind.Color);
    }

    internal static Scene? ReadScene(JsonKeys o)
    {
        o.Text("$schema", "Where editors find the schema of scene files; the program does not use it.", false);
        var camera = o.Object("camera", "Where the picture is taken from, and how wide it looks.") is { } c ? ReadCamera(c) : null;
        var background = o.Color("background", "The colour of a pixel whose ray hits nothing.", Color.Black);
        var models = new List<Model>();
        foreach (var element in o.Objects("models", "What the world holds, an array of models; of two at the same distance the first shows."))
            if (ReadModel(element) is { } model)
                models.Add(model);
        o.Close();
        return o.IsSound ? new(camera!, models, background) : null;
    }

    private static Camera? ReadCamera(JsonKeys o)
    {
        var orElse = new Camera(default, default);
        var camera = new Camera(
            o.Vector("position", "P, where the rays start."),
            o.Vector("target",
                "T, the point that the camera looks at; it is seen in the middle of the picture. It sets the light too: " +
                    "at twice its distance all is black."))
        {
            Up = o.Direction("up", "Which way is up in the picture; any length but zero, not parallel to target - position.", orElse.Up),
            FovY = o.Number("fovY", "The angle from the picture's lower to its upper edge, in degrees.", Limits.Between(0, 180), orElse.FovY),
            Width = o.Whole("width", "Pixels in a row.", 1, Camera.MaxSide, orElse.Width),
            Height = o.Whole("height", "Rows of pixels.", 1, Camera.MaxSide, orElse.Height),
            ZNear = o.Number("zNear", "Nothing nearer is seen.", Limits.NotNegative, orElse.ZNear),
            ZFar = o.Number("zFar", "Nothing farther is seen; greater than zNear.", Limits.None, orElse.ZFar),
            Bias = o.Number("bias", "A hit counts if t > bias; with bias 0, if t >= 0.", Limits.NotNegative, orElse.Bias),
            Clip = o.OptionalChoice("clip", "What zNear and zFar measure: the depth along the view direction or the distance from the camera.",
                "depth", "distance") == "distance" ? ClipMode.Distance : ClipMode.Depth,
            Sample = o.OptionalChoice("sample", "Where in its pixel a ray passes: through the lower left corner or through the middle.",
                "corner", "center") == "center" ? PixelSample.Center : PixelSample.Corner,
        };
        o.Close();

        camera.Check(o.PathOf(""), (key, message) =>
        {
            if (key == "zFar" && !o.Has(key))
                o.Refuse("zNear", $" must be less than {o.PathOf(key)}, which is {camera.ZFar} where it is not given, but is {camera.ZNear}");
            else if (key == "zFar" && !o.Has("zNear"))
                o.Refuse(key, $" must be greater than {o.PathOf("zNear")}, which is {camera.ZNear} where it is not given, but is {camera.ZFar}");
            else if (key == "up" && !o.Has(key))
                o.Refuse(key, $"{message} where it is not given; the camera looks along it: add \"up\": [1, 0, 0]");
            else if (key != "fovY") o.Refuse(key, message); // its limits are the key's
        });
        var fovY = camera.FovY;
        if (fovY is >= 0.2 and < 3)
            o.Warn("fovY", $" is {fovY}; fovY is in degrees, and {fovY} would be {fovY * 180 / Math.PI:0.##} degrees if it were in radians");
        return o.IsSound ? camera : null;
    }

    private static Model? ReadModel(JsonKeys o)
    {
        var name = o.Choice("type", "What the model is.", null, PrimitiveList.Names);
        var type = Array.Find(PrimitiveList.All, type => type.Name == name);
        var model = type is null ? null : ReadModel(o, type);
        // If the type is unknown, only a key that no type has is surely wrong.
        o.Close(type is null ? PrimitiveList.KeysOfAllTypes.Select(key => key.Name) : []);
        return model;
    }

    internal static Model ReadModel(JsonKeys o, PrimitiveType type)
    {
        var model = type.Read(o);
        model.Color = o.Color("color", "Its colour in full light, as [red, green, blue], 1 being full intensity, or as \"#rrggbb\".", Color.White);
        model.Name = o.Text("name", "A name for people; the picture does not depend on it.", false) is { } name ? PrintableText.From(name) : null;
        return model;
    }

    private static SceneReading Unreadable(string path, string message) =>
        new(path, default, "") { Problems = [new Problem(true, path, 0, 0, message, "")] };
}
