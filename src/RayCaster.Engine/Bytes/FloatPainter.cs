namespace RayCaster.Engine;

/// <summary>
/// Paints a part of the picture that one shape covers, in floats; each thread has its own. The error of the levels has one bound for the whole part
/// (<see cref="ErrorBound"/>). Where both ends of a level's range have the same whole part, that is the byte; the few other pixels are cast in
/// doubles.
/// </summary>
internal sealed class FloatPainter : IShapeVisitor
{
    /// <summary>With a greater error, too many bytes would be uncertain.</summary>
    private const double MaxError = 0.02;

    /// <summary>With a smaller error, so few bytes are uncertain that a tighter bound does not pay.</summary>
    private const double GoodError = 0.002;

    private readonly Scene scene;
    private readonly Camera camera;
    private readonly FloatRays rays;
    private readonly (int Index, double Error)[] knownErrors = new (int, double)[8]; // in the strip, of some models
    private readonly uint[] doubts = new uint[Tile.MaxStrip * Tile.MaxSide / FloatPacket.Count]; // a bit for each pixel of each packet
    private CoveredTile covered;
    private PixelRect part;
    private byte[] rgb = [];
    private int first, step;

    public FloatPainter(Scene scene)
    {
        (this.scene, camera) = (scene, scene.Camera);
        rays = new(camera);
    }

    /// <summary>Writes a part's bytes, if its width is a multiple of a packet's and the error is small enough.</summary>
    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    public bool Paint(in CoveredTile covered, byte[] rgb, int first, int step)
    {
        (this.covered, part, this.rgb, this.first, this.step) = (covered, covered.Part, rgb, first, step);
        if (part.Width % FloatPacket.Count != 0 || !covered.View.Accept(this)) return false;

        var packets = part.Width / FloatPacket.Count;
        var some = doubts.AsSpan(0, packets * part.Height);
        for (var place = 0; some.IndexOfAnyExcept(0u) is >= 0 and var next; place++, some = some[(next + 1)..])
        {
            place += next;
            for (var left = some[next]; left != 0; left &= left - 1)
            {
                var (row, column) = (place / packets, place % packets * FloatPacket.Count + BitOperations.TrailingZeroCount(left));
                Write(column, row, rgb.AsSpan(first + row * step + 3 * column, 3));
            }
        }
        return true;
    }

    /// <summary>Writes a pixel by the definition.</summary>
    private void Write(int column, int row, Span<byte> rgb)
    {
        var ray = camera.RayThrough(part.Column + column, part.Row + row);
        var hit = scene.Models[covered.Index].Intersect(ray) is { } t ? new(t, covered.Index) : Hit.None;
        (rgb[0], rgb[1], rgb[2]) = scene.Shade(hit).ToBytes();
    }

    /// <summary>Paints the shape, if its error is small enough.</summary>
    public bool Visit<P>(P shape) where P : struct, IPrimitive
    {
        var index = covered.Index;
        var color = scene.Models[index].Color;
        var brightest = Math.Max(color.R, Math.Max(color.G, color.B));
        if (brightest > 1) return false;
        var steepest = -FloatLevel.SlopeOf(brightest, camera.FadeDistance);
        var error = Error(shape, index, GoodError / steepest);
        if (!(error * steepest < MaxError && steepest < 1e30)) return false; // a float holds the slope
        var levels = new FloatLevels(color, camera.FadeDistance, error);
        Paint<P>(shape, levels);
        return true;
    }

    /// <summary>The greatest difference between t in floats and in doubles, of all pixels of a part.</summary>
    /// <remarks>A bound for the whole strip is usually good enough, and serves its other parts, too.</remarks>
    private double Error<P>(in P shape, int index, double goodError) where P : struct, IPrimitive
    {
        if (rays.Begin(part)) Array.Fill(knownErrors, (-1, 0));
        ref var known = ref knownErrors[index % knownErrors.Length];
        if (known.Index != index) known = (index, Error(rays.Strip, shape));
        return known.Error < goodError ? known.Error : Error(part, shape);
    }

    private double Error<P>(in PixelRect part, in P shape) where P : struct, IPrimitive
    {
        var direction = rays.Directions(part);
        var hit = camera.ClipRange.First(shape.Intersect(new Ray<ErrorBound>(camera.Position, direction)), camera.DepthPerT(direction));
        return hit.Hi <= camera.FadeDistance ? hit.Error : double.PositiveInfinity;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private void Paint<P>(P shape, FloatLevels levels) where P : struct, IPrimitive
    {
        Vector3<FloatPacket> origin = camera.Position;
        var (rgb, doubts) = (this.rgb, this.doubts);
        var isFirstCrossing = covered.IsFirstCrossing; // a local stays in a register
        var columns = rays.Across;
        var firstColumn = part.Column - rays.Strip.Column;
        var packets = part.Width / FloatPacket.Count;
        for (int row = 0, next = 0; row < part.Height; row++)
        {
            var upwards = rays.Upwards.At(part.Row - rays.Strip.Row + row);
            var place = first + row * step;
            for (var packet = 0; packet < packets; packet++, next++, place += 3 * FloatPacket.Count)
            {
                var direction = camera.Direction(columns.Load(firstColumn + packet * FloatPacket.Count), upwards);
                var crossings = shape.Intersect(new Ray<FloatPacket>(origin, direction));
                var t = isFirstCrossing ? crossings.Near : camera.ClipRange.First(crossings, camera.DepthPerT(direction));
                doubts[next] = t.Write(levels, rgb, place);
            }
        }
    }
}
