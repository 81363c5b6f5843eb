namespace RayCaster;

/// <summary>Triangles that share their corners, as one model.</summary>
/// <param name="vertices">The corners.</param>
/// <param name="indices">Three places in <paramref name="vertices"/> for each triangle, in file order.</param>
public sealed class Mesh(Vector3[] vertices, int[] indices) : Model
{
    /// <summary>How many triangles the mesh has.</summary>
    public int TriangleCount => indices.Length / 3;

    /// <summary>A triangle by its place in the file, from 0.</summary>
    public Triangle this[int triangle] =>
        new(vertices[indices[3 * triangle]], vertices[indices[3 * triangle + 1]], vertices[indices[3 * triangle + 2]]);

    /// <summary>The nearest of the hits of all triangles; of equal ones the first triangle's.</summary>
    public override double? Intersect(Ray ray)
    {
        double? nearest = null;
        var along = new AlongRay<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        for (var i = 0; i < TriangleCount; i++)
        {
            double t = ray.Clip.First(this[i].Cross(along), (Scalar)ray.ZPerT);
            if (t < (nearest ?? double.PositiveInfinity)) nearest = t;
        }
        return nearest;
    }

    /// <summary>Adds the corners and the places in them.</summary>
    public override void AddTo(SceneDigest digest) =>
        digest.Add("Mesh").Add(vertices.Length).Add(indices.Length).AddBits<Vector3>(vertices).AddBits<int>(indices);

    /// <inheritdoc/>
    internal override int PartCount => TriangleCount;

    /// <inheritdoc/>
    internal override Crossings<N>? Cross<N>(in Ray<N> ray, int part) => this[part].Cross(ray);

    /// <inheritdoc/>
    internal override ISurface SurfaceOf(int part) => this[part];

    /// <inheritdoc/>
    internal override ModelView See(Camera camera, int threads) => new MeshView(vertices, indices, new(camera), threads);
}
