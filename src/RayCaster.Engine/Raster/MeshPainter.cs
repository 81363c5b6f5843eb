namespace RayCaster.Engine;

/// <summary>Paints the tiles of a mesh in floats; each thread has its own. The filter knows a range for each hit's inverse depth; so t and each
/// channel's level have a range, too. Where both ends have the same whole part, that is the byte; the few other pixels are in doubt.</summary>
internal sealed class MeshPainter
{
    /// <summary>With a greater error, too many bytes would be uncertain.</summary>
    private const double MaxError = 0.002;

    /// <summary>The relative error of a t that is computed from its inverse depth. The squares of two slopes, their sum,
    /// its root, the unit, the product and the quotient round by 2⁻²⁴ each. A root halves the relative error of its operand.</summary>
    private const double Roundings = 6.0 / (1 << 24);

    private readonly Scene scene;
    private readonly ScreenSpace screen;
    private readonly Model model;
    private readonly int index;
    private readonly int background; // its bytes
    private readonly float[] squares = new float[Tile.MaxSide]; // of the columns' slopes
    private readonly uint[] doubts = new uint[Tile.MaxSide * Tile.MaxSide / FloatPacket.Count]; // of each packet
    private readonly byte[] rowEnds = new byte[Tile.MaxSide * 3 * FloatPacket.Count]; // of packets that the tile cuts
    private PixelRect tile;
    private byte[] rgb = [];
    private int first, step;

    public MeshPainter(ScreenSpace screen, Scene scene, int index)
    {
        (this.screen, this.scene, this.index, model) = (screen, scene, index, scene.Models[index]);
        var (r, g, b) = scene.Background.ToBytes();
        background = r | (g << 8) | (b << 16);
        // Beyond this t there is no light, even after rounding.
        var most = 2 * scene.Camera.FadeDistance;
        var light = scene.Attenuation(new ErrorBound(0, most, most * Roundings));
        Error = Color.Level(light * Math.Max(model.Color.R, Math.Max(model.Color.G, model.Color.B))).Error + FloatBytes.RoundingOfTheEnds;
        // Floats hold any t that matters; and the axes are so nearly at right angles that it does not count, even for a ray that is hardly along the
        // view.
        IsSupported = FloatBytes.IsSupported && Error < MaxError && screen.ReferenceDepth is > 1e-30 and < 1e30
            && screen.LongestT < 1e4 && screen.Camera.Skew * screen.LongestT < 1e-9;
    }

    /// <summary>Whether the machine and the scene allow it.</summary>
    public bool IsSupported { get; }

    /// <summary>The largest difference between a level and the one in doubles for the same inverse depth.</summary>
    public double Error { get; init; }

    /// <summary>The positions of pixels whose bytes the last painting could not decide.</summary>
    public PooledList<int> Doubts { get; } = new();

    /// <param name="occluderInverseDepth">The least inverse depth of a pixel's hit; rows are <see cref="TilePixels.Stride"/> long.</param>
    /// <param name="candidateInverseDepth">The greatest; 0 where there is no hit.</param>
    /// <param name="exactT">Less than +∞ where the formula has decided about a pixel; null if there is none.</param>
    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    public void Paint(
        in PixelRect tile, float[] occluderInverseDepth, float[] candidateInverseDepth, double[]? exactT, byte[] rgb, int first, int step)
    {
        (this.tile, this.rgb, this.first, this.step) = (tile, rgb, first, step);
        for (var i = 0; i < tile.Width; i++) squares[i] = (float)Square((tile.Column + i - screen.CenterX) / screen.Scale);
        Paint(occluderInverseDepth, candidateInverseDepth, exactT);

        if (tile.Width % FloatPacket.Count is > 0 and var left)
            for (var row = 0; row < tile.Height; row++)
                rowEnds.AsSpan(row * 3 * FloatPacket.Count, 3 * left).CopyTo(rgb.AsSpan(first + row * step + 3 * (tile.Width - left)));
        Doubts.Clear();
        var packets = (tile.Width + FloatPacket.Count - 1) / FloatPacket.Count;
        for (var i = 0; i < packets * tile.Height; i++)
        {
            for (var lanes = doubts[i]; lanes != 0; lanes &= lanes - 1)
                Doubts.Add(i / packets * TilePixels.Stride + i % packets * FloatPacket.Count + BitOperations.TrailingZeroCount(lanes));
        }
    }

    /// <summary>Writes a pixel by the definition.</summary>
    /// <param name="pixel">Its position in the tile.</param>
    /// <param name="t">Where its ray hits the mesh; +∞ if it does not.</param>
    public void Write(int pixel, double t)
    {
        var to = first + pixel / TilePixels.Stride * step + 3 * (pixel % TilePixels.Stride);
        (rgb[to], rgb[to + 1], rgb[to + 2]) = scene.Shade(double.IsPositiveInfinity(t) ? Hit.None : new(t, index)).ToBytes();
    }

    /// <summary>Paints it all and notes which pixels are in doubt.</summary>
    /// <remarks>A ray is √(1 + u² + v²) long where it is 1 deep and moves u across and v upwards: t = unit · √(1 + u² + v²) / inverse
    /// depth.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    private void Paint(float[] occluderInverseDepth, float[] candidateInverseDepth, double[]? exactT)
    {
        var (red, green, blue) = ((FloatPacket)model.Color.R, (FloatPacket)model.Color.G, (FloatPacket)model.Color.B);
        var unit = (FloatPacket)screen.ReferenceDepth;
        var slack = (FloatPacket)Error;
        var packet = 0;
        for (var row = 0; row < tile.Height; row++)
        {
            var upwards = (FloatPacket)(1 + Square((tile.Row + row - screen.CenterY) / screen.Scale));
            for (var i = 0; i < tile.Width; i += FloatPacket.Count, packet++)
            {
                var at = row * TilePixels.Stride + i;
                var inFront = FloatPacket.Load(candidateInverseDepth, at);
                var tTimesW = unit * FloatPacket.Sqrt(upwards + FloatPacket.Load(squares, i));
                var brightest = scene.Attenuation(tTimesW / inFront);
                var darkest = scene.Attenuation(tTimesW / FloatPacket.Load(occluderInverseDepth, at));
                var most = FloatPacket.Pixels(
                    Color.Level(brightest * red) + slack, Color.Level(brightest * green) + slack, Color.Level(brightest * blue) + slack);
                var least = FloatPacket.Pixels(
                    Color.Level(darkest * red) - slack, Color.Level(darkest * green) - slack, Color.Level(darkest * blue) - slack);
                var (to, offset) = i + FloatPacket.Count <= tile.Width ? (rgb, first + row * step + 3 * i) : (rowEnds, row * 3 * FloatPacket.Count);
                var misses = Vector256.Equals(inFront.Lanes, Vector256<float>.Zero).AsInt32();
                var doubt = FloatPacket.WriteRange(least, most, misses, background, to, offset);
                for (var k = 0; exactT is not null && k < FloatPacket.Count; k += Packet.Count)
                    doubt |= Packet.Bits(Packet.Load(exactT, at + k) < double.PositiveInfinity) << k;
                doubts[packet] = doubt;
            }
        }
    }

    private static double Square(double x) => x * x;
}
