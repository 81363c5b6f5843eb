namespace RayCaster.Files;

/// <summary>The triangles into which a polygon is split: each has the polygon's first corner.</summary>
internal static class Fan
{
    /// <summary>What is wrong with a polygon whose fan is folded; follows its place.</summary>
    public const string Warning =
        "is not convex: split as a fan from its first corner it becomes another shape; begin it at another corner, or split it into triangles";

    /// <summary>Below this share of the area, a turned triangle is a rounding error.</summary>
    private const double Least = 1e-9;

    /// <summary>Whether a triangle of the fan is turned over: the first corner does not see all of the polygon.</summary>
    public static bool IsFolded(ReadOnlySpan<int> triangles, ReadOnlySpan<Vector3> vertices)
    {
        var whole = Vector3.Zero;
        for (var i = 0; i < triangles.Length; i += 3) whole += Area(triangles[i..], vertices);
        var least = -Least * (whole * whole);
        for (var i = 0; i < triangles.Length; i += 3)
            if (Area(triangles[i..], vertices) * whole < least) return true;
        return false;
    }

    /// <summary>A vector across a triangle, twice as long as the triangle is large.</summary>
    private static Vector3 Area(ReadOnlySpan<int> triangle, ReadOnlySpan<Vector3> vertices)
    {
        var a = vertices[triangle[0]];
        return (vertices[triangle[1]] - a) % (vertices[triangle[2]] - a);
    }
}
