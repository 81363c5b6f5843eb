namespace RayCaster.Engine;

/// <summary>A bounding volume hierarchy (BVH) over the triangles of a mesh. Bounds reject whole branches; the triangle's own formula decides which
/// triangle is hit, and where, so the result is the one of testing all triangles in order.</summary>
public sealed class TriangleTree
{
    private readonly Vector3[] vertices;
    private readonly int[] indices;
    private readonly int[] order; // triangles by leaf
    private readonly TreeNode[] nodes;
    private readonly int depth;

    /// <param name="indices">Three for each triangle.</param>
    public TriangleTree(Vector3[] vertices, int[] indices, CancellationToken cancellation = default)
    {
        (this.vertices, this.indices) = (vertices, indices);
        (nodes, order, depth) = new TreeBuilder(vertices, indices, cancellation).Build();
    }

    /// <summary>The least t that a function returns for the triangles that a line may cross, in front of its origin or behind it; null for
    /// none.</summary>
    /// <param name="origin">Where the line begins.</param>
    /// <param name="hit">The t of a triangle, by its number in the mesh; null where it has none that counts. A t must lie where the line is within
    /// the triangle's bounds.</param>
    public double? Nearest(Vector3 origin, Vector3 direction, Func<int, double?> hit)
    {
        double? nearest = null;
        if (nodes.Length > 0) Visit(0, new(origin, direction), hit, ref nearest);
        return nearest;
    }

    private void Visit(int index, in Line line, Func<int, double?> hit, ref double? nearest)
    {
        ref readonly var node = ref nodes[index];
        for (var i = node.First; i < node.First + node.Count; i++)
            if (hit(order[i]) is { } t && t < (nearest ?? double.PositiveInfinity))
                nearest = t;
        if (node.IsLeaf) return;

        var (first, second) = (index + 1, node.Second);
        var (t0, t1) = (line.Enters(nodes[first].Bounds), line.Enters(nodes[second].Bounds));
        if (t1 < t0) ((first, second), (t0, t1)) = ((second, first), (t1, t0)); // hits in the nearer one may reject the other
        if (t0 <= (nearest ?? double.MaxValue)) Visit(first, line, hit, ref nearest);
        if (t1 <= (nearest ?? double.MaxValue)) Visit(second, line, hit, ref nearest);
    }

    /// <summary>The t of the nearest hit in each lane of the packet that begins at a pixel; NaN if no hit is nearer than those so far.</summary>
    // Optimised from the first call: many pictures are finished before the runtime would optimise it.
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    internal N Nearest<N>(RayStream rays, int pixel) where N : struct, IPacket<N>
    {
        var best = rays.NearestAt<N>(pixel);
        var hit = Lanes.Broadcast<N>(double.NaN);
        if (nodes.Length == 0) return hit;

        var ray = rays.RaysAt<N>(pixel);
        var along = new RaySpace<N>(ray);
        var origin = rays.Origin;
        var ahead = rays.DirectionAt(pixel);
        var test = new BoundsTest<N>(ray.Direction);

        Span<int> stack = stackalloc int[depth + 1];
        var top = 0;
        stack[top++] = 0;
        while (top > 0)
        {
            var index = stack[--top];
            ref readonly var node = ref nodes[index];
            if (!test.MayHit(node.Bounds.PaddedFrom(origin), best)) continue;
            if (!node.IsLeaf)
            {
                // The child that the first ray enters first is visited first, so that its hits reject the other.
                var isAhead = TreeBuilder.Coordinate(ahead, node.Axis) >= 0;
                stack[top++] = isAhead ? node.Second : index + 1;
                stack[top++] = isAhead ? index + 1 : node.Second;
                continue;
            }
            for (var i = node.First; i < node.First + node.Count; i++)
            {
                var corner = 3 * order[i];
                var triangle = new Triangle(vertices[indices[corner]], vertices[indices[corner + 1]], vertices[indices[corner + 2]]);
                var t = rays.First(pixel, triangle.Intersect(along));
                var nearer = t < best;
                best = N.Select(nearer, t, best);
                hit = N.Select(nearer, t, hit);
            }
        }
        return hit;
    }
}
