namespace RayCaster.Engine;

/// <summary>The rays of a strip in floats, and their error; each thread has its own.</summary>
internal sealed class FloatRays(Camera camera)
{
    public PixelRect Strip { get; private set; }

    /// <summary>What the directions of each column have in common.</summary>
    public Floats Across { get; } = new(Tile.MaxStrip);

    /// <summary>What the directions of each row have in common, from the lowest row.</summary>
    public Floats Upwards { get; } = new(Tile.MaxSide);

    /// <summary>Sets the strip of a part; returns whether it is a new one.</summary>
    public bool Begin(in PixelRect part)
    {
        var strip = new PixelRect(part.Column & -Tile.MaxStrip, part.Row & -Tile.MaxSide, Tile.MaxStrip, Tile.MaxSide);
        if (strip == Strip) return false;
        Strip = strip;
        for (var i = 0; i < strip.Width; i += 2 * Packet.Count)
            Across.Set(i, camera.Across(Packet.Sequence(strip.Column + i)), camera.Across(Packet.Sequence(strip.Column + i + Packet.Count)));
        for (var i = 0; i < strip.Height; i += 2 * Packet.Count)
            Upwards.Set(i, camera.Upwards(Packet.Sequence(strip.Row + i)), camera.Upwards(Packet.Sequence(strip.Row + i + Packet.Count)));
        return true;
    }

    public Vector3<ErrorBound> Directions(in PixelRect part)
    {
        var across = camera.Across(new ErrorBound(part.Column, part.EndColumn - 1, 0));
        var upwards = camera.Upwards(new ErrorBound(part.Row, part.EndRow - 1, 0));
        return camera.Direction(InDoubles(across), InDoubles(upwards));

        static Vector3<ErrorBound> InDoubles(Vector3<ErrorBound> v) =>
            new(ErrorBound.From(v.X.Lo, v.X.Hi), ErrorBound.From(v.Y.Lo, v.Y.Hi), ErrorBound.From(v.Z.Lo, v.Z.Hi));
    }

    /// <summary>Vectors, the numbers of each axis side by side.</summary>
    public readonly struct Floats(int count)
    {
        private readonly float[] x = new float[count], y = new float[count], z = new float[count];

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3<FloatPacket> Load(int first) => new(FloatPacket.Load(x, first), FloatPacket.Load(y, first), FloatPacket.Load(z, first));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3<FloatPacket> At(int row) => new(x[row], y[row], z[row]);

        public void Set(int first, in Vector3<Packet> lower, in Vector3<Packet> upper)
        {
            Vector256.Narrow(lower.X.Lanes, upper.X.Lanes).StoreTo(x, first);
            Vector256.Narrow(lower.Y.Lanes, upper.Y.Lanes).StoreTo(y, first);
            Vector256.Narrow(lower.Z.Lanes, upper.Z.Lanes).StoreTo(z, first);
        }
    }
}
