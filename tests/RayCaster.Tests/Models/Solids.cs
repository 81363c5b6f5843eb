namespace RayCaster.Tests.Models;

/// <summary>Closed meshes around the origin.</summary>
internal static class Solids
{
    /// <summary>The cube from (−1, −1, −1) to (1, 1, 1), two triangles to a face.</summary>
    public static Mesh Cube()
    {
        var vertices = Enumerable.Range(0, 8).Select(i => new Vector3(2 * (i & 1) - 1, (i & 2) - 1, (i & 4) / 2 - 1)).ToArray();
        return new(vertices, [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5]);
    }

    /// <summary>An icosahedron of radius 1, each triangle split into four on the sphere a number of times: 20 · 4ⁿ triangles.</summary>
    public static Mesh Icosphere(int splits)
    {
        var golden = (1 + Math.Sqrt(5)) / 2;
        List<Vector3> vertices = [];
        foreach (var a in new[] { -1.0, 1.0 })
            foreach (var b in new[] { -golden, golden })
                vertices.AddRange([new Vector3(a, b, 0).Normalized, new Vector3(0, a, b).Normalized, new Vector3(b, 0, a).Normalized]);

        // Of all triples of corners the faces are those whose three sides have the icosahedron's length.
        var side = 2 / Math.Sqrt(golden * Math.Sqrt(5));
        bool IsSide(int i, int j) => Math.Abs((vertices[i] - vertices[j]).Length - side) < 1e-9;
        List<int> indices = [];
        for (var i = 0; i < 12; i++)
            for (var j = i + 1; j < 12; j++)
                for (var k = j + 1; k < 12; k++)
                    if (IsSide(i, j) && IsSide(j, k) && IsSide(i, k)) indices.AddRange([i, j, k]);

        for (var n = 0; n < splits; n++)
        {
            Dictionary<(int, int), int> middles = [];
            int Middle(int i, int j)
            {
                var edge = i < j ? (i, j) : (j, i);
                if (!middles.TryGetValue(edge, out var middle))
                {
                    middles[edge] = middle = vertices.Count;
                    vertices.Add((vertices[i] + vertices[j]).Normalized);
                }
                return middle;
            }

            List<int> finer = [];
            for (var i = 0; i < indices.Count; i += 3)
            {
                var (a, b, c) = (indices[i], indices[i + 1], indices[i + 2]);
                var (ab, bc, ca) = (Middle(a, b), Middle(b, c), Middle(c, a));
                finer.AddRange([a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca]);
            }
            indices = finer;
        }
        return new([.. vertices], [.. indices]);
    }
}
