using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>
/// A tree of bounds over the triangles of a mesh (a bounding volume hierarchy, BVH). Bounds reject whole branches; which triangle is hit, and where,
/// always comes from the triangle's own formula, so the answer is the one of asking all triangles in order.
/// </summary>
internal sealed class Hierarchy
{
    private const int MaxLeaf = 4;
    private const int Bins = 16;
    private const int MaxDepthByArea = 64;

    private readonly Vector3[] vertices;
    private readonly int[] indices;
    private readonly int[] order;                 // triangles by leaf
    private readonly List<Node> nodes = [];
    private readonly int depth;

    /// <summary>A branch, whose children are the next node and <c>Second</c>, or a leaf of <c>Count</c> triangles from <c>First</c> in the order.</summary>
    private readonly record struct Node(Bounds Bounds, int Second, int First, int Count, int Axis)
    {
        public bool IsLeaf => Count > 0;
    }

    public Hierarchy(Vector3[] vertices, int[] indices)
    {
        (this.vertices, this.indices) = (vertices, indices);
        order = new int[indices.Length / 3];
        var bounds = new Bounds[order.Length];
        for (var i = 0; i < order.Length; i++)
        {
            order[i] = i;
            bounds[i] = Bounds.Empty.With(vertices[indices[3 * i]]).With(vertices[indices[3 * i + 1]]).With(vertices[indices[3 * i + 2]]);
        }
        if (order.Length > 0) depth = Build(bounds, 0, order.Length, 1);
    }

    /// <summary>The t of the nearest hit in each lane of the packet that begins at a pixel, or NaN; nothing beyond the nearest hit so far is looked for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // a picture is often drawn before the runtime would optimise by itself
    public Packet Nearest(RaySpan span, int pixel)
    {
        Packet best = span.NearestAt<Packet>(pixel), hit = double.NaN;
        if (nodes.Count == 0) return hit;

        var ray = span.RaysAt<Packet>(pixel);
        var along = new AlongRay<Packet>(ray);
        var origin = new Vector3(ray.Origin.X.Lanes[0], ray.Origin.Y.Lanes[0], ray.Origin.Z.Lanes[0]);
        var test = new BoundsTest(ray.Direction);

        Span<int> stack = stackalloc int[depth + 1];
        var top = 0;
        stack[top++] = 0;
        while (top > 0)
        {
            var index = stack[--top];
            var node = nodes[index];
            if (!test.MayHit(node.Bounds.PaddedFrom(origin), best)) continue;
            if (!node.IsLeaf)
            {
                // The child that the first ray comes to first is looked at first, so that its hits reject the other.
                var ahead = Along(node.Axis, ray.Direction) >= 0;
                stack[top++] = ahead ? node.Second : index + 1;
                stack[top++] = ahead ? index + 1 : node.Second;
                continue;
            }
            for (var i = node.First; i < node.First + node.Count; i++)
            {
                var corner = 3 * order[i];
                var triangle = new Triangle(vertices[indices[corner]], vertices[indices[corner + 1]], vertices[indices[corner + 2]]);
                var t = span.First(pixel, triangle.Cross(along));
                var nearer = t < best;
                best = Packet.Select(nearer, t, best);
                hit = Packet.Select(nearer, t, hit);
            }
        }
        return hit;
    }

    private static double Along(int axis, Vector3<Packet> d) => (axis switch { 0 => d.X, 1 => d.Y, _ => d.Z }).Lanes[0];

    /// <summary>Adds the node of a part of the order and returns how deep it goes.</summary>
    private int Build(Bounds[] bounds, int first, int end, int level)
    {
        Bounds all = Bounds.Empty, centers = Bounds.Empty;
        for (var i = first; i < end; i++)
        {
            all = all.With(bounds[order[i]]);
            centers = centers.With(Center(bounds[order[i]]));
        }

        var place = nodes.Count;
        var (axis, middle) = end - first <= MaxLeaf ? (0, first) : Split(bounds, centers, first, end, level);
        if (middle == first)
        {
            nodes.Add(new Node(all, 0, first, end - first, 0));
            return level;
        }
        nodes.Add(default); // its second child is not known yet
        var deepest = Build(bounds, first, middle, level + 1);
        nodes[place] = new Node(all, nodes.Count, 0, 0, axis);
        return Math.Max(deepest, Build(bounds, middle, end, level + 1));
    }

    /// <summary>
    /// Parts the order at <c>Middle</c> so that the surface area heuristic (SAH: area × triangles of both sides) is least over planes at equal steps
    /// along the longest axis (after Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
    /// </summary>
    private (int Axis, int Middle) Split(Bounds[] bounds, Bounds centers, int first, int end, int level)
    {
        var size = centers.Max - centers.Min;
        var axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        var (from, length) = (Coordinate(centers.Min, axis), Coordinate(size, axis));
        int BinOf(int triangle) =>
            Math.Clamp((int)((Coordinate(Center(bounds[triangle]), axis) - from) / length * Bins), 0, Bins - 1);

        var middle = first;
        if (length > 0 && level < MaxDepthByArea)
        {
            var cut = CheapestCut(bounds, first, end, BinOf);
            for (var i = first; i < end; i++)
            {
                if (BinOf(order[i]) >= cut) continue;
                (order[i], order[middle]) = (order[middle], order[i]);
                middle++;
            }
        }
        // Duplicates in one place, or parts so uneven that the tree would not end: halves.
        return middle > first && middle < end ? (axis, middle) : (axis, (first + end) / 2);
    }

    private int CheapestCut(Bounds[] bounds, int first, int end, Func<int, int> binOf)
    {
        Span<Bounds> bins = stackalloc Bounds[Bins];
        Span<int> counts = stackalloc int[Bins];
        bins.Fill(Bounds.Empty);
        for (var i = first; i < end; i++)
        {
            var bin = binOf(order[i]);
            bins[bin] = bins[bin].With(bounds[order[i]]);
            counts[bin]++;
        }

        Span<double> costs = stackalloc double[Bins]; // of cutting before a bin
        Bounds left = Bounds.Empty, right = Bounds.Empty;
        for (int bin = 1, count = 0; bin < Bins; bin++)
        {
            left = left.With(bins[bin - 1]);
            costs[bin] = left.HalfArea * (count += counts[bin - 1]);
        }
        var (best, cheapest) = (1, double.PositiveInfinity);
        for (int bin = Bins - 1, count = 0; bin > 0; bin--)
        {
            right = right.With(bins[bin]);
            costs[bin] += right.HalfArea * (count += counts[bin]);
            if (costs[bin] < cheapest) (best, cheapest) = (bin, costs[bin]);
        }
        return best;
    }

    private static Vector3 Center(Bounds bounds) => 0.5 * bounds.Min + 0.5 * bounds.Max;

    private static double Coordinate(Vector3 v, int axis) => axis switch { 0 => v.X, 1 => v.Y, _ => v.Z };
}
