namespace RayCaster.Teaching;

/// <summary>Finds which triangle of a mesh each pixel shows. The renderer only returns which mesh, and at which t.</summary>
internal static class MeshParts
{
    /// <summary>The index of the triangle at each pixel, in the order of the hit map; 0 where a pixel shows no mesh.</summary>
    public static int[] Find(Scene scene, HitMap hits)
    {
        var parts = new int[hits.Model.Length];
        Array.Fill(parts, -1);
        for (var i = 0; i < scene.Models.Count; i++)
            if (scene.Models[i] is Mesh mesh)
                Find(mesh, i, scene.Camera, hits, parts);
        for (var i = 0; i < parts.Length; i++) parts[i] = Math.Max(0, parts[i]);
        return parts;
    }

    /// <summary>
    /// Tests only pixels where a triangle can show, so a large mesh takes hardly longer than a small one. The triangle at a pixel is the first
    /// whose formula gives the pixel's t to the bit.
    /// </summary>
    private static void Find(Mesh mesh, int index, Camera camera, HitMap hits, int[] parts)
    {
        for (var part = 0; part < mesh.TriangleCount; part++)
        {
            var triangle = mesh[part];
            var extent = Tile.Of(triangle.Bounds.PaddedFrom(camera.Position), camera);
            var (endColumn, endRow) = (Math.Min(camera.Width, extent.EndColumn), Math.Min(camera.Height, extent.EndRow));
            for (var row = extent.Row; row < endRow; row++)
            {
                var line = (camera.Height - 1 - row) * camera.Width;
                for (var column = extent.Column; column < endColumn; column++)
                {
                    if (hits.Model[line + column] != index || parts[line + column] >= 0) continue;
                    var d = camera.Direction<Scalar>(column, row);
                    var crossings = triangle.Intersect(new Ray<Scalar>(camera.Position, d));
                    if (crossings.Near == hits.T[line + column]) parts[line + column] = part;
                }
            }
        }
    }
}
