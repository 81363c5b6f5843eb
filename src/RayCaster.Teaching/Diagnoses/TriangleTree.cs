using System.Runtime.CompilerServices;

namespace RayCaster.Teaching;

/// <summary>
/// The triangles of a mesh, halved and halved again, with bounds around each part. They only reject, and look behind the camera too:
/// what counts is for the lab to say.
/// </summary>
internal sealed class TriangleTree
{
    private const int MaxLeaf = 4;

    private static readonly ConditionalWeakTable<Mesh, TriangleTree> trees = [];

    private readonly Mesh mesh;
    private readonly int[] order;
    private readonly List<(Bounds Bounds, int First, int End, int Second)> nodes = [];  // a branch's first child is the next node

    private TriangleTree(Mesh mesh)
    {
        this.mesh = mesh;
        order = [.. Enumerable.Range(0, mesh.TriangleCount)];
        if (order.Length > 0) Build(0, order.Length);
    }

    /// <summary>The tree of a mesh, built once for all labs.</summary>
    public static TriangleTree Of(Mesh mesh) => trees.GetValue(mesh, static mesh => new(mesh));

    /// <summary>The t of the nearest hit of all triangles; null for none.</summary>
    public double? Nearest(Lab lab, Vector3 d)
    {
        double? nearest = null;
        if (double.IsNaN(d.X + d.Y + d.Z)) return null; // of a mistaken camera: hits nothing, and no bounds would reject it
        if (lab.TrianglesReachOut)
        {
            for (var i = 0; i < mesh.TriangleCount; i++) Keep(lab.First.Do(lab.Triangle.Do(mesh[i], d), d), ref nearest);
        }
        else if (order.Length > 0)
        {
            Visit(0, lab, d, Inverse(d), new AlongRay<Scalar>(lab.RayOf(d)), ref nearest);
        }
        return nearest;
    }

    private void Visit(int index, Lab lab, Vector3 d, Vector3 inverse, in AlongRay<Scalar> along, ref double? nearest)
    {
        var node = nodes[index];
        if (node.Second > 0)
        {
            var (first, second) = (index + 1, node.Second);
            var (t0, t1) = (Enters(nodes[first].Bounds, lab, inverse), Enters(nodes[second].Bounds, lab, inverse));
            if (t1 < t0) ((first, second), (t0, t1)) = ((second, first), (t1, t0)); // the nearer one may spare the other
            if (t0 <= (nearest ?? double.MaxValue)) Visit(first, lab, d, inverse, along, ref nearest);
            if (t1 <= (nearest ?? double.MaxValue)) Visit(second, lab, d, inverse, along, ref nearest);
            return;
        }
        for (var i = node.First; i < node.End; i++)
        {
            var triangle = mesh[order[i]];
            Keep(lab.First.Do(lab.Triangle.IsChanged ? lab.Triangle.Do(triangle, d) : triangle.Intersect(along), d), ref nearest);
        }
    }

    /// <summary>1 / d, coordinate by coordinate.</summary>
    public static Vector3 Inverse(Vector3 d) => new(1 / d.X, 1 / d.Y, 1 / d.Z);

    private static void Keep(double? hit, ref double? nearest)
    {
        if (hit is { } t && t < (nearest ?? double.PositiveInfinity)) nearest = t;
    }

    /// <summary>Whether a line through P passes the bounds by.</summary>
    /// <param name="bounds">The bounds.</param>
    /// <param name="lab">Where P is.</param>
    /// <param name="inverse">1 / d.</param>
    public static bool Misses(Bounds bounds, Lab lab, Vector3 inverse) => double.IsPositiveInfinity(Enters(bounds, lab, inverse));

    /// <summary>The t at which a line through P enters the bounds, behind P too; +∞ if it passes them by.</summary>
    /// <remarks>In a face's plane 0 · ∞ is NaN, of which nothing is known: −∞.</remarks>
    private static double Enters(Bounds bounds, Lab lab, Vector3 inverse)
    {
        var (min, max) = bounds.PaddedFrom(lab.P);
        var (x0, x1) = (min.X * inverse.X, max.X * inverse.X);
        var (y0, y1) = (min.Y * inverse.Y, max.Y * inverse.Y);
        var (z0, z1) = (min.Z * inverse.Z, max.Z * inverse.Z);
        var enters = Math.Max(Math.Min(x0, x1), Math.Max(Math.Min(y0, y1), Math.Min(z0, z1)));
        var leaves = Math.Min(Math.Max(x0, x1), Math.Min(Math.Max(y0, y1), Math.Max(z0, z1)));
        return enters > leaves ? double.PositiveInfinity : double.IsNaN(enters) ? double.NegativeInfinity : enters;
    }

    private void Build(int first, int end)
    {
        Bounds all = Bounds.Empty, centers = Bounds.Empty;
        for (var i = first; i < end; i++)
        {
            all = all.With(mesh[order[i]].Bounds);
            centers = centers.With(Center(order[i]));
        }
        var place = nodes.Count;
        nodes.Add((all, first, end, 0));
        if (end - first <= MaxLeaf) return;

        var size = centers.Max - centers.Min;
        Func<int, double> along = size.X >= size.Y && size.X >= size.Z ? i => Center(i).X
            : size.Y >= size.Z ? i => Center(i).Y
            : i => Center(i).Z;
        var keys = new double[end - first];
        for (var i = 0; i < keys.Length; i++) keys[i] = along(order[first + i]);
        keys.AsSpan().Sort(order.AsSpan(first, keys.Length));
        var middle = (first + end) / 2;
        Build(first, middle);
        nodes[place] = (all, first, end, nodes.Count);
        Build(middle, end);
    }

    private Vector3 Center(int triangle)
    {
        var bounds = mesh[triangle].Bounds;
        return 0.5 * bounds.Min + 0.5 * bounds.Max;
    }
}
