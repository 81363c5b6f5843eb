namespace RayCaster;

/// <summary>Triangles that share their corners, as one model.</summary>
public sealed class Mesh(Vector3[] vertices, int[] indices) : Model
{
    /// <summary>The corners. This is the mesh's own array: do not change it.</summary>
    public Vector3[] Vertices => vertices;

    /// <summary>Three places in <see cref="Vertices"/> for each triangle, in file order. This is the mesh's own array: do not change it.</summary>
    public int[] Indices => indices;

    /// <summary>How many triangles the mesh has.</summary>
    public int TriangleCount => indices.Length / 3;

    /// <summary>A triangle by its number in the file, from 0.</summary>
    public Triangle this[int triangle] =>
        new(vertices[indices[3 * triangle]], vertices[indices[3 * triangle + 1]], vertices[indices[3 * triangle + 2]]);

    /// <summary>The nearest of the hits of all triangles; of equal ones the first triangle's.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override double? Intersect(Ray ray)
    {
        var nearest = double.PositiveInfinity;
        var along = new RaySpace<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        for (var i = 0; i < TriangleCount; i++)
        {
            double t = this[i].Intersect(along).Near;
            if (t < nearest && ray.Counts(t)) nearest = t;
        }
        return nearest < double.PositiveInfinity ? nearest : null;
    }

    /// <summary>A box around all corners, computed again at each call.</summary>
    public override Bounds? Bounds
    {
        get
        {
            var bounds = RayCaster.Bounds.Empty;
            foreach (var vertex in vertices) bounds = bounds.With(vertex);
            return bounds;
        }
    }
}
