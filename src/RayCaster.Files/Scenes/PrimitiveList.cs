namespace RayCaster.Files;

/// <summary>A type of model as a scene file names it.</summary>
/// <param name="Read">Reads the type's own keys; name and colour are the same for all types.</param>
internal sealed record PrimitiveType(string Name, string Meaning, Func<JsonKeys, Model> Read);

/// <summary>All types of models. To add one write its class and a line here (docs/adding-a-primitive.md).</summary>
internal static class PrimitiveList
{
    public static readonly PrimitiveType[] All =
    [
        new("plane", "An infinite plane, visible from both sides.", o =>
            Model.Of(new Plane(
                o.Vector("point", "Q, any point of the plane."),
                o.Direction("normal", "n, across the plane; any length but zero.")))),

        new("sphere", "A sphere, seen from outside or from inside.", o =>
            Model.Of(new Sphere(
                o.Vector("center", "C, the centre."),
                o.Radius("radius", "R, greater than 0.")))),

        new("aabb", "A box with its sides along the axes; it may be flat.", Box),

        new("circle", "A flat disc, visible from both sides.", o =>
            Model.Of(new Circle(
                o.Vector("center", "C, the centre."),
                o.Direction("normal", "n, across the disc; any length but zero."),
                o.Radius("radius", "R, greater than 0.")))),

        new("triangle", "A triangle, visible from both sides.", Triangle),

        new("mesh", "Triangles from a file, or written here.", Mesh),
    ];

    public static readonly string[] Names = Array.ConvertAll(All, type => type.Name);

    /// <summary>The keys of all types; only mistakes need them.</summary>
    public static IReadOnlyList<KeySpec> KeysOfAllTypes => field ??= Describe();

    private static IReadOnlyList<KeySpec> Describe()
    {
        var o = JsonKeys.Describing(out var keys);
        foreach (var type in All) SceneReader.ReadModel(o, type);
        return keys;
    }

    private static Model Box(JsonKeys o)
    {
        var min = o.Vector("min", "B0, the corner with the least coordinates.");
        var max = o.Vector("max", "B1, the corner with the greatest coordinates.");
        InOrder(0, min.X, max.X);
        InOrder(1, min.Y, max.Y);
        InOrder(2, min.Z, max.Z);
        return Model.Of(new Aabb(min, max));

        void InOrder(int axis, double from, double to)
        {
            if (to < from) o.Refuse("max", $" must not be less than {o.PathOf("min", axis)}, which is {from}, but is {to}; swap them?", axis);
        }
    }

    private static Model Triangle(JsonKeys o)
    {
        var (a, b, c) = (o.Vector("a", "A, the first corner."), o.Vector("b", "B, the second corner."), o.Vector("c", "C, the third corner."));
        if (MeshPlacement.IsOnOneLine(a, b, c))
            o.Refuse("c", $" must not lie on one line with {o.PathOf("a")} and {o.PathOf("b")}: the triangle has no area");
        return Model.Of(new Triangle(a, b, c));
    }

    /// <summary>Whether an angle is a multiple of 15 degrees in radians, up to a full turn.</summary>
    private static bool IsPartOfPi(double angle) => Math.Abs(angle) is > 0.1 and < 6.3
        && Math.Abs(Math.IEEERemainder(angle, Math.PI / 12)) < 1e-4;

    /// <summary>Triangles of a file or of the scene, placed; after an error the mesh is empty.</summary>
    private static Model Mesh(JsonKeys o)
    {
        var nothing = new Mesh([], []);
        var file = o.FileName("file", "The mesh file (.obj, .ply or .stl); its path starts at the scene file's folder.");
        var vertices = o.Vectors("vertices", "In place of a file: the corners of the faces.");
        var indices = o.Faces("faces", "Of each face at least three places in vertices, from 0.", vertices);
        var scale = o.Factors("scale", "A factor for all axes, or one for each; none is 0, negative mirrors.", 1);
        var rotate = o.Vector("rotate", "Turns about the x, y and z axis, in this order, in degrees.", Vector3.Zero);
        if (new[] { rotate.X, rotate.Y, rotate.Z }.FirstOrDefault(IsPartOfPi) is var angle and not 0)
            o.Warn("rotate", $" has {angle}; rotate is in degrees, and {angle} looks like {Math.Round(angle * 180 / Math.PI)} degrees in radians");
        var placement = new MeshPlacement(scale, rotate,
            o.Vector("translate", "Where the mesh's origin goes, at last.", Vector3.Zero));
        var key = o.Has("faces") ? "faces" : o.Has("vertices") ? "vertices" : "file";
        if (file == "") o.Refuse("file", $" must not be empty");
        else if (key == "file" && !o.Has(key)) o.Refuse(key, $" is missing: a mesh file (.obj, .ply or .stl), or in place of it vertices and faces");
        else if (key != "file" && o.Has("file")) o.Refuse(key, $" cannot stand beside {o.PathOf("file")}: a mesh has one or the other");
        else if (key == "vertices") o.Refuse(key, $" needs faces beside it");
        else if (key == "faces" && !o.Has("vertices")) o.Refuse(key, $" needs vertices beside it");
        else if (key == "faces" && o.IsSound && vertices.Length == 0) o.Refuse("vertices", $" must have at least one vertex");
        else if (key == "faces" && o.IsSound && indices.Length == 0) o.Refuse(key, $" must have at least one face");
        try
        {
            var isNew = false;
            var data = string.IsNullOrEmpty(file) ? new(vertices, indices) : o.Reading.Mesh(file, out isNew);
            if (!o.IsSound) return nothing;
            if (isNew && data.Warning is { } warning) o.Warn(key, $": {warning}");
            var mesh = placement.Place(data, out var dropped);
            if (mesh.TriangleCount == 0) o.Warn(key, $": nothing of the mesh is left: none of its {dropped} triangles has an area");
            else if (dropped > 0) o.Warn(key, $": {dropped} of {data.Indices.Length / 3} triangles have no area and are dropped");
            return mesh;
        }
        catch (Exception e) when (e is ProblemException or OverflowException or PathTooLongException) // the last only on Windows
        {
            o.Refuse(key, $": {(e is PathTooLongException ? ProblemException.Reason(e) : e.Message)}");
            return nothing;
        }
    }
}
