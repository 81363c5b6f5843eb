namespace RayCaster.Files;

/// <summary>Reads a model of type mesh: a file, and the placement of its triangles.</summary>
internal static class SceneMesh
{
    private static readonly Mesh Nothing = new([], []);

    /// <summary>Reads the keys and the file; after an error the mesh is empty.</summary>
    public static Model Read(SceneObject o)
    {
        var file = o.Text("file", "The mesh file (.obj, .ply or .stl); its path starts at the scene file's folder.");
        var placement = new MeshPlacement(
            o.Factors("scale", "A factor for all axes, or one for each; none is 0, negative mirrors.", 1),
            o.Vector("rotate", "Turns about the x, y and z axis, in this order, in degrees.", Vector3.Zero),
            o.Vector("translate", "Where the mesh's origin goes, at last.", Vector3.Zero));
        if (file is null) return Nothing;
        if (file.Contains('\0')) // which no file system takes
        {
            o.Refuse("file", $" must name a mesh file");
            return Nothing;
        }
        try
        {
            var data = o.Document!.Mesh(file);
            if (!o.IsSound) return Nothing;
            var mesh = placement.Place(data, out var dropped, o.Document.Threads);
            if (dropped > 0) o.Warn("file", $": {dropped} of {data.Indices.Length / 3} triangles have no area and are dropped");
            return mesh;
        }
        catch (Exception e) when (e is MeshFileException or OverflowException)
        {
            o.Refuse("file", $": {e.Message}");
            return Nothing;
        }
    }
}
