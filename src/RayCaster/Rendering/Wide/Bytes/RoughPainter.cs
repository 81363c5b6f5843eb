using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// One thread's tool: paints a part of the picture that one shape covers, in floats. Each channel's level is known up to an error that is the same for the whole
/// part (<see cref="Rounded"/>). Where both ends of that range have the same whole part, that is the byte; the few other pixels are cast in doubles.
/// </summary>
/// <remarks>Where neither the light nor a level is clamped, a level is a linear function of t: two of its values tell all others.</remarks>
internal sealed class RoughPainter(Frame frame)
{
    /// <summary>With a greater error too many pixels would be in doubt.</summary>
    private const double MostError = 0.02;

    /// <summary>So few pixels are in doubt that a closer look is not worth it.</summary>
    private const double GoodError = 0.002;

    private readonly Scene scene = frame.Scene;
    private readonly Camera camera = frame.Scene.Camera;
    private readonly RoughRays rays = new(frame.Scene.Camera);
    private readonly (int Index, double Error)[] knownErrors = new (int, double)[8]; // in the strip, of some models
    private readonly SpanShader shader = frame.Shader;
    private readonly RaySpan span = new(frame.Scene.Camera);
    private readonly ulong[] doubts = new ulong[Tile.MaxStrip * Tile.MaxSide / RoughPacket.Count]; // of each packet
    private Tile part;

    /// <summary>Writes a part's bytes, if its width is one of whole packets and the error is small enough.</summary>
    /// <param name="part">The part, whose pixels' nearest hits are all on the shape.</param>
    /// <param name="isNear">Whether each is surely the shape's first crossing.</param>
    /// <param name="shape">The shape.</param>
    /// <param name="view">Its view, for the pixels in doubt.</param>
    /// <param name="index">Its model's place in the scene.</param>
    /// <param name="rgb">Room for the bytes.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    /// <typeparam name="P">The kind of shape.</typeparam>
    public bool Paint<P>(in Tile part, bool isNear, in P shape, ModelView view, int index, byte[] rgb, int first, int step) where P : struct, IPrimitive
    {
        if (part.Width % RoughPacket.Count != 0) return false;
        this.part = part;
        var color = scene.Models[index].Color;
        var brightest = Math.Max(color.R, Math.Max(color.G, color.B));
        if (brightest > 1) return false;
        var steepest = Slope(brightest);
        var error = Error(shape, index, -GoodError / steepest);
        if (!(error * -steepest < MostError)) return false;

        if (Paint(shape, isNear, color, error, rgb, first, step)) return true;

        for (var i = 0; i < part.Area / RoughPacket.Count; i++)
        {
            if (doubts[i] == 0) continue;
            var (row, packet) = Math.DivRem(i, part.Width / RoughPacket.Count);
            span.Enter<WidePacket>(part.Column + packet * RoughPacket.Count, RoughPacket.Count);
            span.Aim<WidePacket>(part.Row + row);
            view.Meet(span, index);
            shader.Shade(span, 0, rgb.AsSpan(first + row * step + packet * RoughPacket.Count * 3, 3 * RoughPacket.Count));
        }
        return true;
    }

    private Line LineOf(double channel, double error) => new(channel, Slope(channel), error * -Slope(channel) + RoughBytes.RoundingOfALine);

    /// <summary>What the level of a channel changes by for one unit of t.</summary>
    private double Slope(double channel) => ((double)Color.Level<Scalar>(0) - Color.Level<Scalar>(channel)) / camera.Reach;

    /// <summary>How far the t of any pixel of a part may be from the one that doubles give.</summary>
    /// <remarks>A bound for the whole strip is mostly good enough, and then serves other parts of it, too.</remarks>
    private double Error<P>(in P shape, int index, double goodError) where P : struct, IPrimitive
    {
        if (rays.Enter(part)) Array.Fill(knownErrors, (-1, 0));
        ref var known = ref knownErrors[index % knownErrors.Length];
        if (known.Index != index) known = (index, Error(rays.Strip, shape));
        return known.Error < goodError ? known.Error : Error(part, shape);
    }

    private double Error<P>(in Tile part, in P shape) where P : struct, IPrimitive
    {
        var direction = rays.Directions(part);
        var hit = camera.ClipRange.First(shape.Cross(new Ray<Rounded>(camera.Position, direction)), camera.ZPerT(direction));
        return hit.Exact.Hi.Value <= camera.Reach ? hit.Error : double.PositiveInfinity;
    }

    /// <summary>Paints it all and notes which pixels are in doubt; whether none is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private bool Paint<P>(P shape, bool isNear, Color color, double error, byte[] rgb, int first, int step) where P : struct, IPrimitive
    {
        Vector3<RoughPacket> origin = camera.Position;
        var (red, green, blue) = (LineOf(color.R, error), LineOf(color.G, error), LineOf(color.B, error));
        var allSure = RoughBytes.AllLanes;
        var packets = part.Width / RoughPacket.Count; // in a row
        for (var row = 0; row < part.Height; row += 2)
        {
            var upwards = rays.UpwardsFrom(part.Row - rays.Strip.Row + row);
            var hasUpper = row + 1 < part.Height;
            ref var to = ref rgb[first + row * step];
            for (var i = 0; i < packets; i++)
            {
                var at = i * RoughPacket.Count;
                var direction = camera.Direction(rays.AcrossFrom(part.Column - rays.Strip.Column + at), upwards);
                var crossings = shape.Cross(new Ray<RoughPacket>(origin, direction));
                var hit = isNear ? crossings.Near : camera.ClipRange.First(crossings, camera.ZPerT(direction));

                var least = RoughBytes.Packed(red.Least(hit.Lower), green.Least(hit.Lower), blue.Least(hit.Lower));
                var most = RoughBytes.Packed(red.Most(hit.Lower), green.Most(hit.Lower), blue.Most(hit.Lower));
                var sure = Vector512.Equals(least, most).ExtractMostSignificantBits();
                doubts[row * packets + i] = sure ^ RoughBytes.AllLanes;
                allSure &= sure;
                RoughBytes.Store(least, ref Unsafe.Add(ref to, 3 * at));
                if (!hasUpper) continue;

                least = RoughBytes.Packed(red.Least(hit.Upper), green.Least(hit.Upper), blue.Least(hit.Upper));
                most = RoughBytes.Packed(red.Most(hit.Upper), green.Most(hit.Upper), blue.Most(hit.Upper));
                sure = Vector512.Equals(least, most).ExtractMostSignificantBits();
                doubts[(row + 1) * packets + i] = sure ^ RoughBytes.AllLanes;
                allSure &= sure;
                RoughBytes.Store(least, ref Unsafe.Add(ref to, step + 3 * at));
            }
        }
        return allSure == RoughBytes.AllLanes;
    }

    /// <summary>The level of a channel as a function of t, both ends of what it may be.</summary>
    private readonly struct Line
    {
        private readonly Vector512<float> slope, least, most;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Line(double channel, double slope, double error)
        {
            double atZero = Color.Level<Scalar>(channel);
            this.slope = Vector512.Create((float)slope);
            (least, most) = (Vector512.Create((float)(atZero - error)), Vector512.Create((float)(atZero + error)));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector512<float> Least(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, slope, least);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector512<float> Most(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, slope, most);
    }
}
