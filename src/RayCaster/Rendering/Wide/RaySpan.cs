using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The rays of up to 64 pixels side by side in one row, and the nearest hit of each so far. Reused from span to span.</summary>
internal sealed class RaySpan(Camera camera)
{
    /// <summary>The most pixels in a span: few enough to stay in the first-level cache, many enough to make a virtual call cheap.</summary>
    public const int MaxLength = 64;

    private readonly Vector3<Packet> origin = camera.Position;
    private readonly Vector3<Packet>[] direction = new Vector3<Packet>[MaxLength / Packet.Count];
    private readonly Packet[] zPerT = new Packet[MaxLength / Packet.Count];
    private readonly double[] t = new double[MaxLength];
    private readonly double[] model = new double[MaxLength];

    /// <summary>How many packets the span has; the lanes of the last one beyond the span's end are cast, too, and ignored.</summary>
    public int PacketCount { get; private set; }

    /// <summary>The t of the nearest hit of each pixel, +∞ for none.</summary>
    public ReadOnlySpan<double> T => t;

    /// <summary>Which model that is, by its place in the scene; −1 for none.</summary>
    public int ModelAt(int pixel) => (int)model[pixel];

    /// <summary>Aims the span's rays and forgets all hits.</summary>
    /// <param name="column">The first pixel's column.</param>
    /// <param name="row">The row, from the bottom.</param>
    /// <param name="length">How many pixels, at most <see cref="MaxLength"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Aim(int column, int row, int length)
    {
        PacketCount = (length + Packet.Count - 1) / Packet.Count;
        for (var i = 0; i < PacketCount; i++)
        {
            var columns = Packet.Sequence(column + i * Packet.Count);
            direction[i] = camera.Direction<Packet>(columns, row);
            zPerT[i] = camera.ZPerT(direction[i]);
        }
        Array.Fill(t, double.PositiveInfinity);
        Array.Fill(model, -1);
    }

    /// <summary>The rays of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ray<Packet> RaysOf(int packet) => new(origin, direction[packet]);

    /// <summary>The t of the nearest hits of a packet so far.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Packet NearestOf(int packet) => Packet.Load(t, packet);

    /// <summary>The first of the crossings that counts, in each lane, or NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Packet First(int packet, Crossings<Packet> crossings) => camera.ClipRange.First(crossings, zPerT[packet]);

    /// <summary>Keeps the hits of a model that are nearer than all before.</summary>
    /// <param name="packet">The packet.</param>
    /// <param name="hit">The model's t in each lane, NaN for none.</param>
    /// <param name="modelIndex">The model's place in the scene, greater than that of all models before.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Keep(int packet, Packet hit, int modelIndex)
    {
        var nearest = NearestOf(packet);
        var nearer = hit < nearest;
        Packet.Select(nearer, hit, nearest).Store(t, packet);
        Packet.Select(nearer, modelIndex, Packet.Load(model, packet)).Store(model, packet);
    }

    /// <summary>Meets a model that knows only single rays.</summary>
    public void MeetLaneByLane(Model only, int modelIndex)
    {
        for (var i = 0; i < PacketCount * Packet.Count; i++)
        {
            var (packet, lane) = Math.DivRem(i, Packet.Count);
            var d = direction[packet];
            var ray = new Ray(camera.Position, new(d.X.Lanes[lane], d.Y.Lanes[lane], d.Z.Lanes[lane]))
            {
                Clip = camera.ClipRange,
                ZPerT = zPerT[packet].Lanes[lane],
            };
            if (only.Intersect(ray) is not { } hit || !(hit < t[i])) continue;
            t[i] = hit;
            model[i] = modelIndex;
        }
    }
}
