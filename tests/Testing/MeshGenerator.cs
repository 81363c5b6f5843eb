namespace RayCaster.Testing;

/// <summary>Meshes by formula: closed surfaces, seen counter-clockwise from outside.</summary>
internal static class MeshGenerator
{
    /// <summary>A cube around the origin.</summary>
    /// <param name="half">Half of its side.</param>
    public static MeshData Cube(double half)
    {
        var vertices = new Vector3[8]; // bit 0 of the place says x, bit 1 y, bit 2 z
        for (var i = 0; i < 8; i++) vertices[i] = half * new Vector3(2 * (i & 1) - 1, (i & 2) - 1, (i & 4) / 2 - 1);
        int[][] sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        var indices = new List<int>();
        foreach (var s in sides) indices.AddRange([s[0], s[1], s[2], s[0], s[2], s[3]]);
        return new(vertices, [.. indices]);
    }

    /// <summary>A ball of radius 1: an icosahedron whose triangles are cut into four, 20 · 4ⁿ in all. Square roots only, so the same on every
    /// machine.</summary>
    /// <param name="subdivisions">n.</param>
    public static MeshData Icosphere(int subdivisions)
    {
        var golden = (1 + Math.Sqrt(5)) / 2;
        var vertices = new List<Vector3>();
        foreach (var a in new[] { -1, 1 })
            foreach (var b in new[] { -golden, golden })
                vertices.AddRange([new Vector3(0, a, b).Normalized, new Vector3(a, b, 0).Normalized, new Vector3(b, 0, a).Normalized]);

        // The faces of an icosahedron are the triples of vertices that are neighbours, turned so that they face outwards.
        var indices = new List<int>();
        for (var i = 0; i < 12; i++)
            for (var j = i + 1; j < 12; j++)
                for (var k = j + 1; k < 12; k++)
                {
                    var (a, b, c) = (vertices[i], vertices[j], vertices[k]);
                    if (a * b > 0 && b * c > 0 && c * a > 0) indices.AddRange(a % b * c > 0 ? [i, j, k] : [i, k, j]);
                }

        for (; subdivisions > 0; subdivisions--) indices = Quarter(vertices, indices);
        return new([.. vertices], [.. indices]);
    }

    /// <summary>A ball with a smooth pattern of bumps, for benchmarks: the icosphere, each vertex moved outwards or inwards.</summary>
    /// <param name="subdivisions">The icosphere has 20 · 4ⁿ triangles.</param>
    /// <param name="height">How far the bumps rise and fall, in radii.</param>
    /// <param name="waves">Bumps along an axis.</param>
    public static MeshData BumpySphere(int subdivisions, double height = 0.1, double waves = 10)
    {
        var mesh = Icosphere(subdivisions);
        for (var i = 0; i < mesh.Vertices.Length; i++)
        {
            var p = mesh.Vertices[i];
            mesh.Vertices[i] = (1 + height * Math.Sin(waves * p.X) * Math.Sin(waves * p.Y) * Math.Sin(waves * p.Z)) * p;
        }
        return mesh;
    }

    /// <summary>A tube along a knot that winds around a torus: <paramref name="p"/> times around the z axis, <paramref name="q"/> times through
    /// the hole.</summary>
    /// <param name="p">2 for the trefoil.</param>
    /// <param name="q">3 for the trefoil.</param>
    /// <param name="major">The radius of the torus.</param>
    /// <param name="minor">The radius of the torus's own tube, on which the knot lies.</param>
    /// <param name="tube">The radius of the knot's tube.</param>
    /// <param name="rings">Rings along the knot.</param>
    /// <param name="sides">Vertices in a ring.</param>
    public static MeshData TorusKnot(int p, int q, double major, double minor, double tube, int rings, int sides)
    {
        var vertices = new Vector3[rings * sides];
        var indices = new List<int>();
        for (var i = 0; i < rings; i++)
        {
            var (sinP, cosP) = Math.SinCos(2 * Math.PI * p * i / rings);
            var (sinQ, cosQ) = Math.SinCos(2 * Math.PI * q * i / rings);
            var outward = new Vector3(cosQ * cosP, cosQ * sinP, sinQ); // the normal of the torus there
            var distance = major + minor * cosQ;                      // from the z axis
            var center = new Vector3(distance * cosP, distance * sinP, minor * sinQ);
            var along = new Vector3(-p * distance * sinP, p * distance * cosP, 0)
                + q * minor * new Vector3(-sinQ * cosP, -sinQ * sinP, cosQ); // the derivative of center
            var across = (along % outward).Normalized;
            for (var j = 0; j < sides; j++)
            {
                var (sin, cos) = Math.SinCos(2 * Math.PI * j / sides);
                vertices[i * sides + j] = center + tube * (cos * outward + sin * across);
                int At(int ring, int side) => ring % rings * sides + side % sides;
                var (a, b, c, d) = (At(i, j), At(i + 1, j), At(i + 1, j + 1), At(i, j + 1));
                indices.AddRange([a, d, c, a, c, b]);
            }
        }
        return new(vertices, [.. indices]);
    }

    private static List<int> Quarter(List<Vector3> vertices, List<int> indices)
    {
        var middles = new Dictionary<(int, int), int>();
        var quarters = new List<int>(4 * indices.Count);
        for (var i = 0; i < indices.Count; i += 3)
        {
            var (a, b, c) = (indices[i], indices[i + 1], indices[i + 2]);
            var (ab, bc, ca) = (Middle(a, b), Middle(b, c), Middle(c, a));
            quarters.AddRange([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]);
        }
        return quarters;

        int Middle(int a, int b)
        {
            var side = a < b ? (a, b) : (b, a);
            if (middles.TryGetValue(side, out var middle)) return middle;
            vertices.Add((vertices[a] + vertices[b]).Normalized);
            return middles[side] = vertices.Count - 1;
        }
    }
}
