using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The rays of up to 64 pixels side by side in one row of a tile, and the nearest hit of each so far. Reused from span to span.</summary>
internal sealed class RaySpan(Camera camera)
{
    /// <summary>The most pixels in a span: few enough to stay in the first-level cache, many enough to make a virtual call cheap.</summary>
    public const int MaxLength = Tile.MaxSide;

    private const int MaxPackets = MaxLength / Packet.Count;

    private readonly Vector3<Packet> origin = camera.Position;
    private readonly Vector3<Packet>[] across = new Vector3<Packet>[MaxPackets];
    private readonly Vector3<Packet>[] direction = new Vector3<Packet>[MaxPackets];
    private readonly Packet[] zPerT = new Packet[MaxPackets];
    private readonly double[] t = new double[MaxLength];
    private readonly double[] model = new double[MaxLength];

    /// <summary>The first pixel's column, from the left.</summary>
    public int Column { get; private set; }

    /// <summary>The pixels' row, from the bottom.</summary>
    public int Row { get; private set; }

    /// <summary>How many pixels.</summary>
    public int Length { get; private set; }

    /// <summary>How many packets the span has; the lanes of the last one beyond the span's end are cast, too, and ignored.</summary>
    public int PacketCount { get; private set; }

    /// <summary>The t of the nearest hit of each pixel, +∞ for none; numbers beyond the span's length mean nothing.</summary>
    public ReadOnlySpan<double> T => t;

    /// <summary>Which model that is, by its place in the scene; −1 for none.</summary>
    public int ModelAt(int pixel) => (int)model[pixel];

    /// <summary>The models of a packet's hits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Packet ModelsOf(int packet) => Packet.Load(model, packet);

    /// <summary>Comes to the columns that the next rows have in common.</summary>
    /// <param name="column">The first column.</param>
    /// <param name="length">How many, at most <see cref="MaxLength"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Enter(int column, int length)
    {
        (Column, Length) = (column, length);
        PacketCount = (length + Packet.Count - 1) / Packet.Count;
        for (var i = 0; i < PacketCount; i++) across[i] = camera.Across(Packet.Sequence(column + i * Packet.Count));
    }

    /// <summary>Aims the rays of a row and forgets all hits.</summary>
    /// <param name="row">The row, from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Aim(int row)
    {
        Row = row;
        var upwards = camera.Upwards<Packet>(row);
        for (var i = 0; i < PacketCount; i++)
        {
            direction[i] = camera.Direction(across[i], upwards);
            zPerT[i] = camera.ZPerT(direction[i]);
            ((Packet)double.PositiveInfinity).Store(t, i);
            ((Packet)(-1)).Store(model, i);
        }
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
    /// <param name="modelIndex">The model's place in the scene, greater than that of all models before, so that of equal hits the first stays.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Keep(int packet, Packet hit, int modelIndex)
    {
        var nearest = NearestOf(packet);
        var nearer = hit < nearest;
        Packet.Select(nearer, hit, nearest).Store(t, packet);
        Packet.Select(nearer, modelIndex, ModelsOf(packet)).Store(model, packet);
    }

    /// <summary>Meets a model that knows only single rays.</summary>
    public void MeetLaneByLane(Model only, int modelIndex)
    {
        for (var i = 0; i < Length; i++)
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
