namespace RayCaster.Engine;

/// <summary>Builds a <see cref="TriangleTree"/>.</summary>
internal sealed class TreeBuilder
{
    private const int MaxLeaf = 4;
    private const int Bins = 16;
    private const int MaxDepthByArea = 64;

    private readonly int[] order; // triangles by leaf
    private readonly Bounds[] bounds;
    private readonly List<TreeNode> nodes = [];

    public TreeBuilder(Vector3[] vertices, int[] indices)
    {
        order = new int[indices.Length / 3];
        bounds = new Bounds[order.Length];
        for (var i = 0; i < order.Length; i++)
        {
            order[i] = i;
            bounds[i] = Bounds.Empty.With(vertices[indices[3 * i]]).With(vertices[indices[3 * i + 1]]).With(vertices[indices[3 * i + 2]]);
        }
    }

    /// <summary>The nodes, the root first, the order of the triangles in the leaves, and how many nodes lie upon one another at most.</summary>
    public (TreeNode[] Nodes, int[] Order, int Depth) Build()
    {
        var depth = order.Length > 0 ? Add(0, order.Length, 1) : 0;
        return ([.. nodes], order, depth);
    }

    /// <summary>Adds the node of a part of the order and returns how deep it goes.</summary>
    private int Add(int first, int end, int level)
    {
        Bounds all = Bounds.Empty, centers = Bounds.Empty;
        for (var i = first; i < end; i++)
        {
            all = all.With(bounds[order[i]]);
            centers = centers.With(Center(bounds[order[i]]));
        }

        var place = nodes.Count;
        var (axis, middle) = end - first <= MaxLeaf ? (0, first) : Split(centers, first, end, level);
        if (middle == first)
        {
            nodes.Add(new TreeNode(all, 0, first, end - first, 0));
            return level;
        }
        nodes.Add(default); // its second child is not known yet
        var deepest = Add(first, middle, level + 1);
        nodes[place] = new TreeNode(all, nodes.Count, 0, 0, axis);
        return Math.Max(deepest, Add(middle, end, level + 1));
    }

    /// <summary>Parts the order at <c>Middle</c> so that the surface area heuristic (SAH: area × triangles of both sides) is least over planes at
    /// equal steps along the longest axis (after Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).</summary>
    private (int Axis, int Middle) Split(Bounds centers, int first, int end, int level)
    {
        var size = centers.Max - centers.Min;
        var axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        var (from, length) = (Coordinate(centers.Min, axis), Coordinate(size, axis));
        int BinOf(int triangle) =>
            Math.Clamp((int)((Coordinate(Center(bounds[triangle]), axis) - from) / length * Bins), 0, Bins - 1);

        var middle = first;
        if (length > 0 && level < MaxDepthByArea)
        {
            var cut = CheapestCut(first, end, BinOf);
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

    private int CheapestCut(int first, int end, Func<int, int> binOf)
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

    /// <summary>A coordinate by the number of its axis.</summary>
    public static double Coordinate(Vector3 v, int axis) => axis switch { 0 => v.X, 1 => v.Y, _ => v.Z };
}

/// <summary>A branch, whose children are the next node and <c>Second</c>, or a leaf of <c>Count</c> triangles from <c>First</c> in the
/// order.</summary>
internal readonly record struct TreeNode(Bounds Bounds, int Second, int First, int Count, int Axis)
{
    public bool IsLeaf => Count > 0;
}
