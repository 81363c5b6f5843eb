namespace RayCaster.Engine;

/// <summary>Builds a <see cref="TriangleTree"/>.</summary>
internal sealed class TreeBuilder
{
    private const int MaxLeaf = 4;
    private const int MaxUnevenLevels = 64;

    private readonly CancellationToken cancellation;
    private readonly int[] order; // triangles by leaf
    private readonly Bounds[] bounds;
    private readonly List<TreeNode> nodes = [];

    public TreeBuilder(Vector3[] vertices, int[] indices, CancellationToken cancellation)
    {
        this.cancellation = cancellation;
        order = new int[indices.Length / 3];
        bounds = new Bounds[order.Length];
        for (var i = 0; i < order.Length; i++)
        {
            order[i] = i;
            bounds[i] = Bounds.Empty.With(vertices[indices[3 * i]]).With(vertices[indices[3 * i + 1]]).With(vertices[indices[3 * i + 2]]);
        }
    }

    /// <summary>The nodes, the root first; the order of the triangles in the leaves; and the tree's depth.</summary>
    public (TreeNode[] Nodes, int[] Order, int Depth) Build()
    {
        var depth = order.Length > 0 ? Add(0, order.Length, 1) : 0;
        return ([.. nodes], order, depth);
    }

    /// <summary>Adds the node of a part of the order and returns its depth.</summary>
    private int Add(int first, int end, int level)
    {
        cancellation.ThrowIfCancellationRequested();
        Bounds all = Bounds.Empty, centers = Bounds.Empty;
        for (var i = first; i < end; i++)
        {
            all = all.With(bounds[order[i]]);
            centers = centers.With(Center(bounds[order[i]]));
        }

        var index = nodes.Count;
        var (axis, middle) = end - first <= MaxLeaf ? (0, first) : Split(centers, first, end, level);
        if (middle == first)
        {
            nodes.Add(new TreeNode(all, 0, first, end - first, 0));
            return level;
        }
        nodes.Add(default); // the second child is not known yet
        var deepest = Add(first, middle, level + 1);
        nodes[index] = new TreeNode(all, nodes.Count, 0, 0, axis);
        return Math.Max(deepest, Add(middle, end, level + 1));
    }

    /// <summary>Parts the order at <c>Middle</c>, by a plane across the middle of the longest axis.</summary>
    private (int Axis, int Middle) Split(Bounds centers, int first, int end, int level)
    {
        var size = centers.Max - centers.Min;
        var axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        var plane = Coordinate(Center(centers), axis);
        var middle = first;
        for (var i = first; i < end && level < MaxUnevenLevels; i++)
        {
            if (!(Coordinate(Center(bounds[order[i]]), axis) < plane)) continue;
            (order[i], order[middle]) = (order[middle], order[i]);
            middle++;
        }
        // If all are on one side, as duplicates are, or the tree becomes too deep: halves.
        return (axis, middle > first && middle < end ? middle : (first + end) / 2);
    }

    private static Vector3 Center(Bounds bounds) => 0.5 * bounds.Min + 0.5 * bounds.Max;

    public static double Coordinate(Vector3 v, int axis) => axis switch { 0 => v.X, 1 => v.Y, _ => v.Z };
}

/// <summary>A branch, whose children are the next node and <c>Second</c>, or a leaf of <c>Count</c> triangles from <c>First</c> in the
/// order.</summary>
internal readonly record struct TreeNode(Bounds Bounds, int Second, int First, int Count, int Axis)
{
    public bool IsLeaf => Count > 0;
}
