using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>One thread's tool: the rays of a strip in floats, and how far from those in doubles they may be.</summary>
internal sealed class RoughRays(Camera camera)
{
    private readonly Floats across = new(Tile.MaxStrip), upwards = new(Tile.MaxSide + RoughPacket.Count); // one row more than there are is asked for

    /// <summary>The strip.</summary>
    public Tile Strip { get; private set; }

    /// <summary>Goes to the strip of a part; whether it is another one than before.</summary>
    public bool Enter(in Tile part)
    {
        var strip = new Tile(part.Column & -Tile.MaxStrip, part.Row & -Tile.MaxSide, Tile.MaxStrip, Tile.MaxSide);
        if (strip == Strip) return false;
        Strip = strip;
        for (var i = 0; i < strip.Width; i += RoughPacket.Count)
            across.Set(i, camera.Across(WidePacket.Sequence(strip.Column + i)), camera.Across(WidePacket.Sequence(strip.Column + i + WidePacket.Count)));
        for (var i = 0; i < strip.Height; i += RoughPacket.Count)
            upwards.Set(i, camera.Upwards(WidePacket.Sequence(strip.Row + i)), camera.Upwards(WidePacket.Sequence(strip.Row + i + WidePacket.Count)));
        return true;
    }

    /// <summary>The directions of all rays of a part.</summary>
    public Vector3<Rounded> Directions(in Tile part)
    {
        var across = camera.Across(new Rounded(part.Column, part.EndColumn - 1, 0));
        var upwards = camera.Upwards(new Rounded(part.Row, part.EndRow - 1, 0));
        return camera.Direction(InDoubles(across), InDoubles(upwards));

        static Vector3<Rounded> InDoubles(Vector3<Rounded> v) => new(Rounded.From(v.X.Lo, v.X.Hi), Rounded.From(v.Y.Lo, v.Y.Hi), Rounded.From(v.Z.Lo, v.Z.Hi));
    }

    /// <summary>What the directions of sixteen columns have in common.</summary>
    /// <param name="column">The first, from the strip's left side.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<RoughPacket> AcrossFrom(int column) =>
        new(RoughPacket.Of(Load(across.X, column)), RoughPacket.Of(Load(across.Y, column)), RoughPacket.Of(Load(across.Z, column)));

    /// <summary>What the directions of two rows have in common.</summary>
    /// <param name="row">The lower one, from the strip's lowest.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<RoughPacket> UpwardsFrom(int row) => new(Two(upwards.X, row), Two(upwards.Y, row), Two(upwards.Z, row));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> Load(float[] numbers, int first) => Vector512.LoadUnsafe(ref numbers[first]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RoughPacket Two(float[] numbers, int first) => new(Vector512.Create(numbers[first]), Vector512.Create(numbers[first + 1]));

    private readonly struct Floats(int count)
    {
        public readonly float[] X = new float[count], Y = new float[count], Z = new float[count];

        public void Set(int first, in Vector3<WidePacket> lower, in Vector3<WidePacket> upper)
        {
            Vector512.Narrow(lower.X.Lanes, upper.X.Lanes).StoreUnsafe(ref X[first]);
            Vector512.Narrow(lower.Y.Lanes, upper.Y.Lanes).StoreUnsafe(ref Y[first]);
            Vector512.Narrow(lower.Z.Lanes, upper.Z.Lanes).StoreUnsafe(ref Z[first]);
        }
    }
}
