namespace RayCaster.Teaching;

/// <summary>Where the rays of a lab hit a mesh. A tree rejects triangles, also behind the camera; the lab decides which hits count.</summary>
internal static class MeshHits
{
    /// <summary>The t of the nearest hit of all triangles; null for none.</summary>
    public static double? Nearest(Lab lab, Mesh mesh, Vector3 d)
    {
        if (double.IsNaN(d.X + d.Y + d.Z)) return null; // of a mistaken camera: hits nothing, and no bounds would reject it
        var along = new AlongRay<Scalar>(lab.RayOf(d));
        if (!lab.TrianglesReachOut) return mesh.Tree.Nearest(lab.P, d, HitOf);

        double? nearest = null;
        for (var i = 0; i < mesh.TriangleCount; i++)
            if (HitOf(i) is { } t && t < (nearest ?? double.PositiveInfinity))
                nearest = t;
        return nearest;

        double? HitOf(int triangle) =>
            lab.First.Do(lab.Triangle.IsChanged ? lab.Triangle.Do(mesh[triangle], d) : mesh[triangle].Intersect(along), d);
    }
}
