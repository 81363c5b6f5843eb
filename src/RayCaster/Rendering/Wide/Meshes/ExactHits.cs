using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Asks the triangles' formula where each of four rays hits its own triangle.</summary>
internal sealed class ExactHits(Camera camera, Vector3[] vertices, int[] indices)
{
    private readonly double[] columns = new double[Packet.Count], rows = new double[Packet.Count], hits = new double[Packet.Count];
    private readonly int[] triangles = new int[Packet.Count], places = new int[Packet.Count];
    private int count;

    /// <summary>The t of each lane's hit that counts, or NaN. A lane without a triangle (−1) is asked about that of another lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Packet Hit(RaySpan span, int pixel, Vector128<int> triangleOfLane) =>
        span.First(pixel, Cross(span.RaysAt<Packet>(pixel), triangleOfLane));

    /// <summary>Asks about a pixel and a triangle, sooner or later, and keeps the t if it is less than what stands at the place.</summary>
    public void Add(int column, int row, int triangle, int place, double[] least)
    {
        (columns[count], rows[count], triangles[count], places[count]) = (column, row, triangle, place);
        if (++count == Packet.Count) Flush(least);
    }

    /// <summary>Asks about all that is left.</summary>
    public void Flush(double[] least)
    {
        if (count == 0) return;
        for (var i = count; i < Packet.Count; i++) (columns[i], rows[i], triangles[i]) = (columns[0], rows[0], triangles[0]);
        var direction = camera.Direction(Packet.Load(columns, 0), Packet.Load(rows, 0));
        var crossings = Cross(new Ray<Packet>(camera.Position, direction), Vector128.Create<int>(triangles));
        camera.ClipRange.First(crossings, camera.ZPerT(direction)).Store(hits, 0);
        for (var i = 0; i < count; i++)
            if (hits[i] < least[places[i]])
                least[places[i]] = hits[i];
        count = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)] // not inlined: in a caller grown too large operators, silently, become calls
    private Crossings<Packet> Cross(in Ray<Packet> rays, Vector128<int> triangleOfLane)
    {
        var any = Math.Max(Math.Max(triangleOfLane[0], triangleOfLane[1]), Math.Max(triangleOfLane[2], triangleOfLane[3]));
        var lanes = 3 * Vector128.ConditionalSelect(Vector128.LessThan(triangleOfLane, Vector128<int>.Zero), Vector128.Create(any), triangleOfLane);
        var (t0, t1, t2, t3) = (lanes[0], lanes[1], lanes[2], lanes[3]);
        var a = Lanes.Gather(vertices, indices[t0], indices[t1], indices[t2], indices[t3]);
        var b = Lanes.Gather(vertices, indices[t0 + 1], indices[t1 + 1], indices[t2 + 1], indices[t3 + 1]);
        var c = Lanes.Gather(vertices, indices[t0 + 2], indices[t1 + 2], indices[t2 + 2], indices[t3 + 2]);
        return Triangle.Cross(new AlongRay<Packet>(rays), a, b, c);
    }
}
