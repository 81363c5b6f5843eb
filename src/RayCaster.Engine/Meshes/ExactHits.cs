using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>Asks the triangles' formula where each ray of a packet hits its own triangle.</summary>
internal sealed class ExactHits<N>(ScreenSpace screen) where N : struct, IPacket<N>
{
    private readonly double[] columns = new double[N.Count], rows = new double[N.Count], hits = new double[N.Count], nearness = new double[N.Count];
    private readonly int[] triangles = new int[N.Count], places = new int[N.Count];
    private Vector3[] vertices = [];
    private int[] indices = [];
    private int count;

    public void Show(Vector3[] vertices, int[] indices) => (this.vertices, this.indices) = (vertices, indices);

    /// <summary>Where rays cross triangles, a lane for each pair.</summary>
    /// <param name="first">The place there of the first lane's triangle, which those of the others follow.</param>
    // in a caller grown too large operators, silently, become calls
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public Crossings<N> Intersect(in Ray<N> rays, RawSpan<int> triangles, int first) => Triangle.Intersect(
        new AlongRay<N>(rays),
        N.Gather(vertices, indices, triangles, first, 0), N.Gather(vertices, indices, triangles, first, 1),
        N.Gather(vertices, indices, triangles, first, 2));

    /// <summary>Asks about a pixel and a triangle, sooner or later, and keeps the t if it is less than what stands at the place.</summary>
    /// <param name="place">Where the pixel's numbers stand.</param>
    /// <param name="least">Of each pixel the least t so far.</param>
    /// <param name="covered">Of each pixel the greatest w so far, less what may be rounded.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int column, int row, int triangle, int place, double[] least, float[] covered)
    {
        (columns[count], rows[count], triangles[count], places[count]) = (column, row, triangle, place);
        if (++count == N.Count) Flush(least, covered);
    }

    public void Flush(double[] least, float[] covered)
    {
        if (count == 0) return;
        for (var i = count; i < N.Count; i++) (columns[i], rows[i], triangles[i]) = (columns[0], rows[0], triangles[0]);
        Ask();
        for (var i = 0; i < count; i++)
        {
            if (!(hits[i] < least[places[i]])) continue;
            least[places[i]] = hits[i];
            covered[places[i]] = Math.Max(covered[places[i]], (float)nearness[i]);
        }
        count = 0;
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Ask()
    {
        var direction = screen.Camera.Direction(N.Load(columns, 0), N.Load(rows, 0));
        var crossings = Intersect(new Ray<N>(screen.Camera.Position, direction), new(triangles), 0);
        var hit = screen.Camera.ClipRange.First(crossings, screen.Camera.ZPerT(direction));
        hit.Store(hits, 0);
        (Lanes.Broadcast<N>(screen.Unit * (1 - 1e-5)) / (hit * -(direction * (Vector3<N>)screen.Camera.W))).Store(nearness, 0);
    }
}
