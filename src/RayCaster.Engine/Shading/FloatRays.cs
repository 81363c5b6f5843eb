using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>The rays of a strip in floats, and their error; each thread has its own.</summary>
internal sealed class FloatRays(Camera camera)
{
    public Tile Strip { get; private set; }

    /// <summary>What the directions of each column have in common.</summary>
    public Floats Across { get; } = new(Tile.MaxStrip);

    /// <summary>What the directions of each row have in common, from the lowest row.</summary>
    public Floats Upwards { get; } = new(Tile.MaxSide + FloatPacket.Count); // one row more than the strip has is read

    /// <summary>Goes to the strip of a part; returns whether it is a new one.</summary>
    public bool Enter(in Tile part)
    {
        var strip = new Tile(part.Column & -Tile.MaxStrip, part.Row & -Tile.MaxSide, Tile.MaxStrip, Tile.MaxSide);
        if (strip == Strip) return false;
        Strip = strip;
        for (var i = 0; i < strip.Width; i += FloatPacket.Count)
            Across.Set(
                i, camera.Across(WidePacket.Sequence(strip.Column + i)), camera.Across(WidePacket.Sequence(strip.Column + i + WidePacket.Count)));
        for (var i = 0; i < strip.Height; i += FloatPacket.Count)
            Upwards.Set(
                i, camera.Upwards(WidePacket.Sequence(strip.Row + i)), camera.Upwards(WidePacket.Sequence(strip.Row + i + WidePacket.Count)));
        return true;
    }

    /// <summary>The directions of all rays of a part.</summary>
    public Vector3<ErrorBound> Directions(in Tile part)
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

        /// <summary>Sixteen of them, the same in both rows.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3<FloatPacket> From(int first) => new(Load(x, first), Load(y, first), Load(z, first));

        /// <summary>One for each of two rows.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector3<FloatPacket> Two(int first) => new(Two(x, first), Two(y, first), Two(z, first));

        public void Set(int first, in Vector3<WidePacket> lower, in Vector3<WidePacket> upper)
        {
            Vector512.Narrow(lower.X.Lanes, upper.X.Lanes).StoreTo(x, first);
            Vector512.Narrow(lower.Y.Lanes, upper.Y.Lanes).StoreTo(y, first);
            Vector512.Narrow(lower.Z.Lanes, upper.Z.Lanes).StoreTo(z, first);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static FloatPacket Load(float[] numbers, int first) => FloatPacket.Of(numbers.Load512(first));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static FloatPacket Two(float[] numbers, int first) => new(Vector512.Create(numbers[first]), Vector512.Create(numbers[first + 1]));
    }
}
