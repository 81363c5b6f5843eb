using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>
/// One thread's tool: paints a part of the picture that one shape covers, or several, in floats. Each channel's level is known up to an error
/// that is
/// the same for the
/// whole part (<see cref="ErrorBound"/>). Where both ends of that range have the same whole part, that is the byte; the few other pixels are cast in
/// doubles.
/// </summary>
internal sealed class FloatPainter : IShapeVisitor
{
    /// <summary>With a greater error too many pixels would be in doubt.</summary>
    private const double MostError = 0.02;

    /// <summary>With a smaller error so few pixels are in doubt that a closer look is not worth it.</summary>
    private const double GoodError = 0.002;

    private readonly Scene scene;
    private readonly Camera camera;
    private readonly FloatRays rays;
    private readonly (int Index, double Error)[] knownErrors = new (int, double)[8]; // in the strip, of some models
    private readonly ushort[] doubts; // a bit for each pixel of each packet
    private readonly FloatLayers layers;
    private Tile part;
    private FloatPixels pixels;
    private CoveringShape current; // the shape that is painted
    private bool isOnly;           // one shape covers the part

    /// <param name="scene">What is drawn.</param>
    public FloatPainter(Scene scene)
    {
        (this.scene, camera) = (scene, scene.Camera);
        rays = new(camera);
        doubts = new ushort[Tile.MaxStrip * Tile.MaxSide / FloatPacket.Count];
        layers = new(doubts);
    }

    /// <summary>Writes a part's bytes, if its width is one of whole packets and all errors are small enough.</summary>
    /// <param name="covered">The part and its shapes; several only in a small part.</param>
    /// <param name="rgb">Room for the bytes.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    public bool Paint(CoveredTile covered, byte[] rgb, int first, int step)
    {
        (part, pixels) = (covered.Part, new(rgb, first, step, doubts, covered.Part.Width / FloatPacket.Count));
        if (part.Width % FloatPacket.Count != 0) return false;
        isOnly = covered.Shapes.Count == 1;
        if (!isOnly) layers.Clear();
        foreach (var shape in covered.Shapes)
        {
            current = shape;
            if (!shape.View.Accept(this)) return false;
        }
        if (!isOnly) layers.Write(part, rgb, first, step);

        var packets = part.Width / FloatPacket.Count;
        var some = doubts.AsSpan(0, packets * part.Height);
        for (var place = 0; some.IndexOfAnyExcept((ushort)0) is >= 0 and var next; place++, some = some[(next + 1)..])
        {
            place += next;
            for (uint left = some[next]; left != 0; left &= left - 1)
            {
                var (row, column) = (place / packets, place % packets * FloatPacket.Count + BitOperations.TrailingZeroCount(left));
                Write(column, row, covered.Shapes, rgb.AsSpan(first + row * step + 3 * column, 3));
            }
        }
        return true;
    }

    /// <summary>Writes a pixel by the definition.</summary>
    private void Write(int column, int row, List<CoveringShape> shapes, Span<byte> rgb)
    {
        var ray = camera.CastRay(part.Column + column, part.Row + row);
        foreach (var shape in shapes) ray.Meet(scene.Models[shape.Index]);
        (rgb[0], rgb[1], rgb[2]) = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
    }

    /// <summary>Paints one of the shapes, if its error is small enough.</summary>
    public bool Visit<P>(P shape) where P : struct, IPrimitive
    {
        var (index, isNear) = (current.Index, current.IsNear);
        var color = scene.Models[index].Color;
        var brightest = Math.Max(color.R, Math.Max(color.G, color.B));
        if (brightest > 1) return false;
        var steepest = -FloatLevel.SlopeOf(brightest, camera.Reach);
        var error = Error(shape, index, GoodError / steepest);
        if (!(error * steepest < MostError)) return false;
        if (isOnly) Paint(shape, isNear, color, error, pixels);
        else Paint(shape, isNear, color, error, layers.Add(error, part.Width / FloatPacket.Count));
        return true;
    }

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
        var hit = camera.ClipRange.First(shape.Intersect(new Ray<ErrorBound>(camera.Position, direction)), camera.ZPerT(direction));
        return hit.Hi <= camera.Reach ? hit.Error : double.PositiveInfinity;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private void Paint<P, T>(P shape, bool isNear, Color color, double error, T target) where P : struct, IPrimitive where T : struct, IFloatTarget
    {
        Vector3<FloatPacket> origin = camera.Position;
        var (red, green, blue) = (new FloatLevel(color.R, camera.Reach, error), new FloatLevel(color.G, camera.Reach, error),
            new FloatLevel(color.B, camera.Reach, error));
        // locals stay in registers
        var (columns, firstColumn, packets) = (rays.Across, part.Column - rays.Strip.Column, part.Width / FloatPacket.Count);
        for (var row = 0; row < part.Height; row += 2)
        {
            var upwards = rays.Upwards.Two(part.Row - rays.Strip.Row + row);
            for (var packet = 0; packet < packets; packet++)
            {
                var direction = camera.Direction(columns.From(firstColumn + packet * FloatPacket.Count), upwards);
                var crossings = shape.Intersect(new Ray<FloatPacket>(origin, direction));
                var hit = isNear ? crossings.Near : camera.ClipRange.First(crossings, camera.ZPerT(direction));
                target.Take(row, packet, hit.Lower, Least(hit.Lower, red, green, blue), Most(hit.Lower, red, green, blue));
                if (row + 1 < part.Height)
                    target.Take(row + 1, packet, hit.Upper, Least(hit.Upper, red, green, blue), Most(hit.Upper, red, green, blue));
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Vector512<int> Least(Vector512<float> t, FloatLevel r, FloatLevel g, FloatLevel b) =>
            FloatBytes.Packed(r.Least(t), g.Least(t), b.Least(t));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Vector512<int> Most(Vector512<float> t, FloatLevel r, FloatLevel g, FloatLevel b) =>
            FloatBytes.Packed(r.Most(t), g.Most(t), b.Most(t));
    }
}
