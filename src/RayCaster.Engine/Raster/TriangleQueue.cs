namespace RayCaster.Engine;

/// <summary>Packs visible triangles into full groups of eight: of eight triangles that are projected together often only some are visible. And while
/// triangles are only collected, no instruction waits for a result.</summary>
internal sealed class TriangleQueue
{
    public const int Limit = 128;

    private const int Room = Limit + 8;

    private static readonly int[] Orders = MakeOrders();

    private readonly int[] orders = Orders; // code with AggressiveOptimization would check at each use whether the static field is initialised
    private readonly float[] corners = new float[9 * Room];
    private readonly int[] triangles = new int[Room];

    public int Count { get; private set; }

    public bool IsFull => Count > Limit - 8;

    public RawSpan<int> Triangles => new(triangles);

    /// <summary>Adds some of eight triangles, while it is not full.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(in EightTriangles t, Vector256<int> ids, uint lanes)
    {
        var order = orders.Load256((int)(8 * lanes));
        Vector256.ShuffleNative(t.A.X, order).StoreTo(corners, Count);
        Vector256.ShuffleNative(t.A.Y, order).StoreTo(corners, Count + Room);
        Vector256.ShuffleNative(t.A.InverseDepth, order).StoreTo(corners, Count + 2 * Room);
        Vector256.ShuffleNative(t.B.X, order).StoreTo(corners, Count + 3 * Room);
        Vector256.ShuffleNative(t.B.Y, order).StoreTo(corners, Count + 4 * Room);
        Vector256.ShuffleNative(t.B.InverseDepth, order).StoreTo(corners, Count + 5 * Room);
        Vector256.ShuffleNative(t.C.X, order).StoreTo(corners, Count + 6 * Room);
        Vector256.ShuffleNative(t.C.Y, order).StoreTo(corners, Count + 7 * Room);
        Vector256.ShuffleNative(t.C.InverseDepth, order).StoreTo(corners, Count + 8 * Room);
        Vector256.ShuffleNative(ids, order).StoreTo(triangles, Count);
        Count += BitOperations.PopCount(lanes);
    }

    /// <summary>Eight of them; if fewer are left, the other lanes are meaningless.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public EightTriangles Load(int first) => new() { A = Points(first), B = Points(first + 3 * Room), C = Points(first + 6 * Room) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private EightPoints Points(int first) => new(
        corners.Load256(first), corners.Load256(first + Room), corners.Load256(first + 2 * Room));

    public void Clear() => Count = 0;

    /// <summary>For each mask of eight lanes, the numbers of the lanes that are set, in order.</summary>
    private static int[] MakeOrders()
    {
        var orders = new int[8 << 8];
        for (var mask = 0; mask < 1 << 8; mask++)
            for (int lane = 0, count = 0; lane < 8; lane++)
                if ((mask >> lane & 1) != 0)
                    orders[8 * mask + count++] = lane;
        return orders;
    }
}
