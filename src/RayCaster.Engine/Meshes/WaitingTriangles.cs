using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>
/// Triangles that wait until there are many of them: of eight that come together often only some need a further look; and while they are only collected,
/// nothing depends on what comes out, so that the processor can work far ahead.
/// </summary>
internal sealed class WaitingTriangles
{
    /// <summary>The most that ever wait.</summary>
    public const int Limit = 128;

    private const int Room = Limit + 8;

    private static readonly int[] Orders = MakeOrders();

    private readonly int[] orders = Orders; // a field of its own: code compiled early asks at each use whether a static one is there
    private readonly float[] corners = new float[9 * Room];
    private readonly int[] triangles = new int[Room];

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>Whether there is no room for another eight.</summary>
    public bool IsFull => Count > Limit - 8;

    /// <summary>The number of the first one, which those of the others follow.</summary>
    public ref int Triangle => ref triangles[0];

    /// <summary>Adds some of eight triangles, while it is not full.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(in EightTriangles t, Vector256<int> ids, uint lanes)
    {
        var order = Vector256.LoadUnsafe(ref orders[8 * lanes]);
        ref var at = ref corners[Count];
        Vector256.ShuffleNative(t.A.X, order).StoreUnsafe(ref at);
        Vector256.ShuffleNative(t.A.Y, order).StoreUnsafe(ref Unsafe.Add(ref at, Room));
        Vector256.ShuffleNative(t.A.W, order).StoreUnsafe(ref Unsafe.Add(ref at, 2 * Room));
        Vector256.ShuffleNative(t.B.X, order).StoreUnsafe(ref Unsafe.Add(ref at, 3 * Room));
        Vector256.ShuffleNative(t.B.Y, order).StoreUnsafe(ref Unsafe.Add(ref at, 4 * Room));
        Vector256.ShuffleNative(t.B.W, order).StoreUnsafe(ref Unsafe.Add(ref at, 5 * Room));
        Vector256.ShuffleNative(t.C.X, order).StoreUnsafe(ref Unsafe.Add(ref at, 6 * Room));
        Vector256.ShuffleNative(t.C.Y, order).StoreUnsafe(ref Unsafe.Add(ref at, 7 * Room));
        Vector256.ShuffleNative(t.C.W, order).StoreUnsafe(ref Unsafe.Add(ref at, 8 * Room));
        Vector256.ShuffleNative(ids, order).StoreUnsafe(ref triangles[Count]);
        Count += BitOperations.PopCount(lanes);
    }

    /// <summary>Eight of them; where fewer are left, the other lanes hold what was there before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public EightTriangles See(int first) => new() { A = Points(first), B = Points(first + 3 * Room), C = Points(first + 6 * Room) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private EightPoints Points(int first) => new(
        Vector256.LoadUnsafe(ref corners[first]), Vector256.LoadUnsafe(ref corners[first + Room]), Vector256.LoadUnsafe(ref corners[first + 2 * Room]));

    /// <summary>Forgets all.</summary>
    public void Clear() => Count = 0;

    /// <summary>For each mask of eight lanes the numbers of the lanes that are set, from the first place on.</summary>
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
