namespace RayCaster.Files;

/// <summary>
/// Reads a camera's path from a file (docs/frames.md): JSON as in a scene file, with an array of <c>keys</c> and an interpolation.
/// </summary>
public static class CameraPathReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="camera">The scene's camera: its target and fovY are the defaults of a key.</param>
    /// <param name="report">All mistakes in the file, as text for people; empty if there are none.</param>
    /// <returns>The path, or null if there is an error.</returns>
    public static CameraPath? Read(string path, Camera camera, out string report) =>
        ShortFile.Read(path, "the camera's path", o => ReadPath(o, camera), out report);

    private static CameraPath? ReadPath(SceneObject o, Camera camera)
    {
        o.Text("$schema", "Not used by the program.", false);
        var isSmooth = o.OptionalChoice(
            "interpolation", "How the camera goes from key to key: in a curve or straight.", "smooth", "linear") == "smooth";
        var keys = new List<CameraKey>();
        foreach (var element in o.Objects("keys", "Where the camera is and when, an array of at least two."))
        {
            var key = new CameraKey(
                element.Number("time", "When; each key later than the one before.", Limits.None),
                element.Vector("position", "P, where the camera is."),
                element.Vector("target", "T, where it looks; the scene's target where it is left out.", camera.Target),
                element.Number(
                    "fovY", "The vertical field of view in degrees; the scene's where it is left out.", Limits.Between(0, 180), camera.FovY));
            element.Close();
            if (keys.Count > 0 && key.Time <= keys[^1].Time)
                element.Refuse("time", $" must be later than that of the key before, which is {keys[^1].Time}, but is {key.Time}");
            if ((key.Target - key.Position).Length == 0) element.Refuse("position", $" must differ from the target, but both are {key.Target}");
            keys.Add(key);
        }
        if (o.Has("keys") && keys.Count < 2 && o.IsSound)
            o.Refuse("keys", $" must be at least two, but there {(keys.Count == 1 ? "is one" : "is none")}");
        o.Close();
        return o.IsSound ? new(keys, isSmooth) : null;
    }
}
