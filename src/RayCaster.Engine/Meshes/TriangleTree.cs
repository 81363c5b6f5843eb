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
        double t = Nearest<Scalar, FunctionHits>(
            origin, direction, direction, double.NegativeInfinity, double.PositiveInfinity, new FunctionHits(hit));
        return double.IsNaN(t) ? null : t;
    }

    /// <summary>The t of the nearest hit in each lane of the packet that begins at a pixel; NaN if no hit is nearer than those so far.</summary>
    internal N Nearest<N>(RayStream rays, int pixel) where N : struct, IPacket<N>
    {
        var ray = rays.RaysAt<N>(pixel);
        return Nearest(
            rays.Origin, ray.Direction, rays.DirectionAt(pixel), 0, rays.NearestAt<N>(pixel),
            new FormulaHits<N>(vertices, indices, rays, pixel, ray));
    }

    /// <summary>The nearest hit of each ray that lies from <paramref name="least"/> on and before <paramref name="best"/>; NaN for none.</summary>
    /// <param name="direction">The rays' directions; they share one origin.</param>
    /// <param name="ahead">The direction of one of them.</param>
    // Optimised from the first call: many pictures are finished before the runtime would optimise it.
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private N Nearest<N, H>(Vector3 origin, Vector3<N> direction, Vector3 ahead, double least, N best, H hits)
        where N : struct, IReal<N> where H : struct, ITriangleHits<N>
    {
        var hit = Lanes.Broadcast<N>(double.NaN);
        if (nodes.Length == 0) return hit;

        var test = new BoundsTest<N>(direction);
        Span<int> stack = stackalloc int[depth + 1];
        var top = 0;
        stack[top++] = 0;
        while (top > 0)
        {
            var index = stack[--top];
            ref readonly var node = ref nodes[index];
            if (H.All(test.Misses(node.Bounds.PaddedFrom(origin), least, best))) continue;
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
                var t = hits.Of(order[i]);
                var nearer = t < best;
                best = N.Select(nearer, t, best);
                hit = N.Select(nearer, t, hit);
            }
        }
        return hit;
    }

    private interface ITriangleHits<N> where N : struct, IReal<N>
    {
        /// <summary>Each ray's t with a triangle, by its number in the mesh; NaN for none.</summary>
        N Of(int triangle);

        static abstract bool All(N mask);
    }

    private readonly struct FormulaHits<N>(Vector3[] vertices, int[] indices, RayStream rays, int pixel, in Ray<N> ray) : ITriangleHits<N>
        where N : struct, IPacket<N>
    {
        private readonly RaySpace<N> along = new(ray);

        public N Of(int triangle)
        {
            var corner = 3 * triangle;
            var shape = new Triangle(vertices[indices[corner]], vertices[indices[corner + 1]], vertices[indices[corner + 2]]);
            return rays.First(pixel, shape.Intersect(along));
        }

        public static bool All(N mask) => Lanes.All(mask);
    }

    private readonly struct FunctionHits(Func<int, double?> hit) : ITriangleHits<Scalar>
    {
        public Scalar Of(int triangle) => hit(triangle) ?? double.NaN;

        public static bool All(Scalar mask) => mask.Holds;
    }
}
