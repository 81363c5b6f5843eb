namespace RayCaster.Engine;

/// <summary>Compares pixels of a drawn picture with the definition (<see cref="ScalarRenderer"/>): of each picture 20 to some 600, in squares that
/// are spread over its models and their outlines.</summary>
/// <remarks>A mesh's triangles, and thousands of models, are left out where their boxes are certainly beside the rays; the nearer the rays of a
/// square are to each other, the fewer boxes must be asked.</remarks>
internal sealed class DefinitionCheck
{
    private const int MinPixels = 20, MaxPixels = 600, SideOfSquare = 32;

    /// <summary>Fewer models are intersected with each ray, whatever their bounds are.</summary>
    private const int FewModels = 1000;

    private readonly Scene scene;
    private readonly Camera camera;
    private readonly ScreenSpace screen;
    private readonly Model[] models; // the scene's, with parts of its meshes
    private readonly List<(int Column, int Line)> pixels = []; // square by square; lines count from the picture's top
    private readonly int side, step; // pixels along a square, and from one to the next
    private readonly byte[] drawn;
    private (byte R, byte G, byte B)[]? right; // as the definition draws them
    private int nextLine;

    /// <summary>Chooses the pixels.</summary>
    /// <param name="first">The first line that is drawn, from the top.</param>
    /// <param name="end">The line after the last one.</param>
    public DefinitionCheck(Scene scene, int first, int end, int threads)
    {
        (this.scene, camera, screen, nextLine) = (scene, scene.Camera, new(scene.Camera), first);
        var (triangles, others) = (0L, 0L);
        models = new Model[scene.Models.Count];
        for (var i = 0; i < models.Length; i++)
        {
            var model = scene.Models[i];
            models[i] = model is Mesh mesh ? new MeshProbe(SpatialOrder.Of(mesh), screen, threads) { Color = mesh.Color } : model;
            if (model is Mesh { TriangleCount: var count }) triangles += count;
            else others++;
        }

        // Each costs some percent of the drawing at most.
        var most = (long)camera.Width * (end - first) / 500 + triangles / 2000;
        if (others > 0) most = Math.Min(most, 20_000 / others);
        var wanted = screen.IsFine ? Math.Clamp(most, MinPixels, MaxPixels) : MinPixels;
        var squares = 8 + 100_000 / (1 + triangles / TriangleBoxes.ClusterLength);
        if (others > FewModels) squares = Math.Min(squares, 1 + 20_000 / others);
        squares = Math.Min(squares, wanted);
        side = (int)Math.Ceiling(Math.Sqrt((double)wanted / squares));
        squares = (wanted + side * side - 1) / (side * side);
        step = SideOfSquare / side;
        var random = new Random(1); // the same pixels in each run
        for (var i = 0L; i < squares; i++) AddSquare(random, i, squares, first, end);
        drawn = new byte[3 * pixels.Count];
    }

    /// <summary>Adds a square where one of the models may show.</summary>
    private void AddSquare(Random random, long number, long count, int first, int end)
    {
        var model = models.Length > 0 ? models[number * models.Length / count] : null;
        var (column, row) = (model as MeshProbe)?.RandomPixel(random) ?? RandomPixelIn(random, model?.Bounds);
        var (left, top) = (column - (side - 1) * step / 2, Math.Clamp(camera.Height - 1 - row, first, end - 1) - (side - 1) * step / 2);
        for (var i = 0; i < side * side; i++)
            pixels.Add((Math.Clamp(left + i % side * step, 0, camera.Width - 1), Math.Clamp(top + i / side * step, first, end - 1)));
    }

    /// <summary>A pixel in which something within bounds may show; each fourth lies on the border of such pixels.</summary>
    private (int Column, int Row) RandomPixelIn(Random random, Bounds? bounds)
    {
        var seen = bounds is { } known ? new ScreenBounds(camera).TileOf(known) : PixelRect.Everywhere;
        var (x, y) = (random.NextDouble(), random.NextDouble());
        if (random.Next(4) == 0) (x, y) = random.Next(2) == 0 ? (Math.Round(x), y) : (x, Math.Round(y));
        var (width, height) = (Math.Min(seen.Width, camera.Width - seen.Column), Math.Min(seen.Height, camera.Height - seen.Row));
        return (seen.Column + (int)(x * Math.Max(0, width - 1)), seen.Row + (int)(y * Math.Max(0, height - 1)));
    }

    /// <param name="rgb">Whole lines, three bytes a pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Sample(ReadOnlySpan<byte> rgb)
    {
        var (width, lines) = (camera.Width, rgb.Length / 3 / camera.Width);
        for (var i = 0; i < pixels.Count; i++)
            if (pixels[i] is var (column, line) && line >= nextLine && line < nextLine + lines)
                rgb.Slice(3 * ((line - nextLine) * width + column), 3).CopyTo(drawn.AsSpan(3 * i));
        nextLine += lines;
    }

    /// <summary>Draws while another thread, if there is one, casts the pixels by the definition.</summary>
    public void RunAlongside(Action draw, int threads)
    {
        if (threads > 1) ThreadTeam.Help(1, () => right = Reference(PixelOf), draw);
        else draw();
        right ??= Reference(PixelOf);

        static (byte R, byte G, byte B) PixelOf(Scene part, int[] near, int column, int line) => ScalarRenderer.Pixel(part, column, line);
    }

    /// <summary>What the definition gives for each pixel, from a scene of the models that its ray may meet.</summary>
    /// <param name="define">Of a scene, the places of its models in the whole scene, a column, and a line from the top.</param>
    private T[] Reference<T>(Func<Scene, int[], int, int, T> define)
    {
        var defined = new T[pixels.Count];
        for (var first = 0; first < defined.Length; first += side * side)
        {
            var near = ModelsNear(first);
            var part = scene with { Models = Array.ConvertAll(near, i => models[i]) };
            for (var i = first; i < first + side * side; i++)
            {
                var pyramid = PyramidOf(i, i);
                foreach (var model in part.Models)
                    if (model is MeshProbe probe) probe.Pixel = pyramid;
                defined[i] = define(part, near, pixels[i].Column, pixels[i].Line);
            }
        }
        return defined;
    }

    /// <summary>The places of the models that the rays of a square may meet.</summary>
    private int[] ModelsNear(int first)
    {
        var pyramid = PyramidOf(first, first + side * side - 1);
        var near = new List<int>();
        for (var i = 0; i < models.Length; i++)
            if (models[i] is MeshProbe part ? part.SetSquare(pyramid)
                : models.Length <= FewModels || pyramid is not { } rays || models[i].Bounds is not { } bounds
                || !IsOutside(rays, bounds.PaddedFrom(camera.Position)))
                near.Add(i);
        return [.. near];

        static bool IsOutside(in Pyramid rays, Bounds bounds) => rays.IsOutside<Scalar>(bounds.Min, bounds.Max).Holds;
    }

    /// <summary>The pyramid of the rays from one pixel to another below it and to its right; null if rounding may leave one out.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private Pyramid? PyramidOf(int first, int last)
    {
        if (!screen.IsFine) return null;
        var ((left, top), (right, bottom)) = (pixels[first], pixels[last]);
        return new(camera, new(left, camera.Height - 1 - bottom, right - left + 1, bottom - top + 1));
    }

    /// <summary>The first pixel whose bytes differ from the definition's, once all lines are taken, as a message; null if all are equal.</summary>
    public string? Difference()
    {
        var part = new Picture(1, 1); // through the picture's own code, too
        for (var i = 0; i < pixels.Count; i++)
        {
            part[0, 0] = right![i];
            var fast = (drawn[3 * i], drawn[3 * i + 1], drawn[3 * i + 2]);
            if (fast != part[0, 0]) return $"{PlaceOf(i)}: the engine gives {fast}, ScalarRenderer {part[0, 0]}";
        }
        return null;
    }

    /// <summary>The first pixel whose hit differs from the definition's, as a message; null if all are equal.</summary>
    public string? Difference(HitMap hits)
    {
        var defined = Reference((part, near, column, line) =>
            ScalarRenderer.Cast(part, column, camera.Height - 1 - line) is { Model: >= 0 and var i } hit ? hit with { Model = near[i] } : Hit.None);
        for (var i = 0; i < defined.Length; i++)
        {
            var fast = hits[pixels[i].Column, pixels[i].Line];
            if (fast != defined[i]) return $"{PlaceOf(i)}: the engine gives {fast}, ScalarRenderer {defined[i]}";
        }
        return null;
    }

    private string PlaceOf(int pixel) => $"column {pixels[pixel].Column}, line {pixels[pixel].Line}";
}
