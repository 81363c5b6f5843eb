namespace RayCaster.Engine;

/// <summary>
/// The rays of up to 64 pixels side by side in one row of a tile, or of all rows of a small part, and the nearest hit of each so far. One object
/// serves many streams. Arrays hold one number for each pixel, and packets of any width read from them; lanes beyond the stream's end are cast and
/// ignored.
/// </summary>
internal sealed class RayStream(Camera camera, int capacity = RayStream.MaxLength)
{
    /// <summary>The most pixels in a stream: they fit into the first-level cache, and one virtual call for so many pixels costs little.</summary>
    public const int MaxLength = Tile.MaxSide;

    /// <summary>The most pixels of a small part whose rows are cast at once; they fit into the first-level cache, too. (The parts of a batch are
    /// larger.)</summary>
    public const int MaxArea = 256;

    private readonly ColumnDirections columns = new(camera, MaxLength);
    private readonly double[] x = new double[capacity], y = new double[capacity], z = new double[capacity];
    private readonly double[] depthPerT = new double[capacity];
    private readonly double[] near = new double[capacity], far = new double[capacity]; // the crossings with one model
    private readonly double[] t = new double[capacity];
    private readonly double[] model = new double[capacity];
    private Ray?[] single = []; // of each pixel, once a scalar shape needs it

    /// <summary>The first pixel's column, from the left.</summary>
    public int Column { get; private set; }

    /// <summary>The lowest row, from the bottom.</summary>
    public int Row { get; private set; }

    /// <summary>How many numbers there are from the first pixel to the last.</summary>
    public int Length { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => (Rows - 1) * Pitch + Width; }

    public int Width { get; private set; }

    public int Rows { get; private set; } = 1;

    /// <summary>The distance in the arrays from a pixel to the one above it.</summary>
    public int Pitch { get; private set; }

    /// <summary>The t of the nearest hit of each pixel, +∞ for none; numbers beyond the stream's length mean nothing.</summary>
    public ReadOnlySpan<double> T => t;

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void CopyModels(int first, Span<int> to)
    {
        for (; to.Length >= Packet.Count; to = to[Packet.Count..], first += Packet.Count) ModelsAt<Packet>(first).ToInts().CopyTo(to);
        for (var i = 0; i < to.Length; i++) to[i] = (int)model[first + i];
    }

    /// <summary>Prepares the columns that the next rows have in common.</summary>
    /// <param name="length">How many, at most <see cref="MaxLength"/>.</param>
    /// <param name="pitch">The distance from row to row; the number of columns if left out.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Begin<N>(int column, int length, int? pitch = null) where N : struct, IPacket<N>
    {
        (Column, Width, Pitch, Rows) = (column, length, pitch ?? length, 1);
        columns.Begin<N>(column, length);
    }

    /// <summary>Computes the directions of a row's rays, or of several rows', and forgets all hits.</summary>
    /// <param name="rows">How many rows; more than one only if the pitch is a multiple of the packet's width.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Aim<N>(int row, int rows = 1) where N : struct, IPacket<N>
    {
        (Row, Rows) = (row, rows);
        if (single.Length > 0) Array.Clear(single);
        for (var i = 0; i < rows; i++) AimRow<N>(row + i, i * Pitch);
    }

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void AimRow<N>(int row, int first) where N : struct, IPacket<N>
    {
        var upwards = camera.Upwards(Lanes.Broadcast<N>(row));
        for (var i = 0; i < Width; i += N.Count)
        {
            var direction = camera.Direction(columns.At<N>(i), upwards);
            direction.X.Store(x, first + i);
            direction.Y.Store(y, first + i);
            direction.Z.Store(z, first + i);
            camera.DepthPerT(direction).Store(depthPerT, first + i);
            Lanes.Broadcast<N>(double.PositiveInfinity).Store(t, first + i);
            Lanes.Broadcast<N>(-1).Store(model, first + i);
        }
    }

    /// <summary>Marks numbers outside the stream's columns and rows as hidden: nothing is nearer than −∞.</summary>
    public void Hide(int first, int count) => Array.Fill(t, double.NegativeInfinity, first, count);

    public Vector3 Origin { get; } = camera.Position;

    public Vector3 DirectionAt(int pixel) => new(x[pixel], y[pixel], z[pixel]);

    /// <summary>The rays of the packet that begins at a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ray<N> RaysAt<N>(int pixel) where N : struct, IPacket<N> =>
        new(Origin, new Vector3<N>(N.Load(x, pixel), N.Load(y, pixel), N.Load(z, pixel)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N NearestAt<N>(int pixel) where N : struct, IPacket<N> => N.Load(t, pixel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ModelsAt<N>(int pixel) where N : struct, IPacket<N> => N.Load(model, pixel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N DepthPerTAt<N>(int pixel) where N : struct, IPacket<N> => N.Load(depthPerT, pixel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set<N>(int pixel, N hits, N models) where N : struct, IPacket<N>
    {
        hits.Store(t, pixel);
        models.Store(model, pixel);
    }

    /// <summary>Stores a model's crossings with the packet that begins at a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void StoreCrossings<N>(int pixel, Crossings<N> crossings) where N : struct, IPacket<N>
    {
        crossings.Near.Store(near, pixel);
        crossings.Far.Store(far, pixel);
    }

    /// <summary>Keeps those of the stored crossings that count and are nearer than all hits before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    public void MergeStored<N>(int modelIndex) where N : struct, IPacket<N>
    {
        for (int i = 0, end = Length; i < end; i += N.Count)
            MergeNearest(i, First(i, new Crossings<N>(N.Load(near, i), N.Load(far, i))), Lanes.Broadcast<N>(modelIndex));
    }

    /// <summary>The first of the crossings that counts, in each lane, or NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N First<N>(int pixel, Crossings<N> crossings) where N : struct, IPacket<N> =>
        camera.ClipRange.First(crossings, N.Load(depthPerT, pixel));

    /// <summary>Keeps the hits of a model that are nearer than all before.</summary>
    /// <param name="hit">The model's t in each lane, NaN for none.</param>
    /// <param name="modelIndex">The model's index in the scene: of equal hits, the first model's stays, in whatever order they are found.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MergeNearest<N>(int pixel, N hit, N modelIndex) where N : struct, IPacket<N>
    {
        var (nearest, models) = (NearestAt<N>(pixel), ModelsAt<N>(pixel));
        var better = Ray.IsNearer(hit, nearest) | (N.Equal(hit, nearest) & (modelIndex < models));
        Set(pixel, N.Select(better, hit, nearest), N.Select(better, modelIndex, models));
    }

    /// <summary>Begins with the hits of a stream that holds all pixels of this one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    public void CopyHits<N>(RayStream whole) where N : struct, IPacket<N>
    {
        var first = (Row - whole.Row) * whole.Pitch + Column - whole.Column;
        for (var row = 0; row < Rows; row++)
            for (var i = 0; i < Width; i += N.Count)
                Set(row * Pitch + i, whole.NearestAt<N>(first + row * whole.Pitch + i), whole.ModelsAt<N>(first + row * whole.Pitch + i));
    }

    /// <summary>Intersects a scalar shape ray by ray and keeps hits that are nearer than all before.</summary>
    public void IntersectOneByOne(Model only, int modelIndex)
    {
        if (single.Length == 0) single = new Ray[capacity];
        for (var i = 0; i < Length; i++)
        {
            var ray = single[i] ??= new(Origin, DirectionAt(i)) { ClipRange = camera.ClipRange, DepthPerT = depthPerT[i] };
            if (only.Intersect(ray) is not { } hit || !(Ray.IsNearer<Scalar>(hit, t[i]).Holds || (hit == t[i] && modelIndex < model[i])))
                continue;
            t[i] = hit;
            model[i] = modelIndex;
        }
    }
}
