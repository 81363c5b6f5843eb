namespace RayCaster.Engine;

/// <summary>Compares pixels of a drawn picture with the definition (<see cref="ScalarRenderer"/>): first one of each model, then the corners, then
/// random ones, as many as cost at most 5 % of the drawing.</summary>
internal sealed class DefinitionCheck
{
    private const int MaxModels = 32, RandomPixels = 32;

    private readonly Scene scene;
    private readonly List<(int Column, int Line)> pixels = []; // lines count from the picture's top
    private readonly byte[] drawn;
    private (byte R, byte G, byte B)[]? right;
    private int nextLine;

    /// <summary>Chooses the pixels.</summary>
    /// <param name="first">The first line that is drawn, from the top.</param>
    /// <param name="end">The line after the last one.</param>
    /// <param name="minPixels">How many pixels are compared even if that takes long, as in a mesh of millions of triangles.</param>
    public DefinitionCheck(Scene scene, int first, int end, int minPixels)
    {
        this.scene = scene;
        nextLine = first;
        var (width, camera) = (scene.Camera.Width, scene.Camera);
        var screenBounds = new ScreenBounds(camera);
        foreach (var model in scene.Models.Take(MaxModels))
            if (model.Bounds is { } bounds && screenBounds.TileOf(bounds) is { Area: > 0 } seen)
                Add(seen.Column + Math.Min(seen.Width, width) / 2, // bounds around the camera reach beyond the picture
                    camera.Height - 1 - (seen.Row + Math.Min(seen.Height, camera.Height) / 2));
        Add(0, first);
        Add(width - 1, end - 1);
        Add(width - 1, first);
        Add(0, end - 1);
        var random = new Random(1); // the same pixels in each run
        for (var i = 0; i < RandomPixels; i++) Add(random.Next(width), random.Next(first, end));

        // A crossing takes up to ten times as long as drawing a pixel, so this is at most 5 % of the drawing: in a large mesh one pixel or none.
        var count = Math.Max(minPixels, (long)width * (end - first) / 200 / Math.Max(1, scene.ShapeCount));
        if (pixels.Count > count) pixels.RemoveRange((int)count, pixels.Count - (int)count);
        drawn = new byte[3 * pixels.Count];

        void Add(int column, int line) => pixels.Add((Math.Clamp(column, 0, width - 1), Math.Clamp(line, first, end - 1)));
    }

    /// <summary>Takes the next lines that were drawn.</summary>
    /// <param name="rgb">Whole lines, three bytes a pixel.</param>
    public void Take(ReadOnlySpan<byte> rgb)
    {
        var (width, lines) = (scene.Camera.Width, rgb.Length / 3 / scene.Camera.Width);
        for (var i = 0; i < pixels.Count; i++)
            if (pixels[i] is var (column, line) && line >= nextLine && line < nextLine + lines)
                rgb.Slice(3 * ((line - nextLine) * width + column), 3).CopyTo(drawn.AsSpan(3 * i));
        nextLine += lines;
    }

    /// <summary>Draws while another thread, if there is one, computes the pixels by the definition.</summary>
    public void Beside(Action draw, int threads)
    {
        if (threads > 1) ThreadTeam.Help(1, Compute, draw);
        else draw();
        if (right is null) Compute();
    }

    private void Compute() => right = [.. pixels.Select(pixel => Defined(pixel.Column, pixel.Line))];

    /// <summary>A pixel as the definition draws it, also through the picture's own code.</summary>
    private (byte R, byte G, byte B) Defined(int column, int line)
    {
        var part = new Picture(1, 1);
        part[0, 0] = ScalarRenderer.Pixel(scene, column, line);
        return part[0, 0];
    }

    /// <summary>The first pixel whose bytes differ from the definition's, once all lines are taken, as a message; null if all are equal.</summary>
    public string? Difference()
    {
        for (var i = 0; i < pixels.Count; i++)
        {
            var (column, line) = pixels[i];
            var fast = (drawn[3 * i], drawn[3 * i + 1], drawn[3 * i + 2]);
            if (fast != right![i]) return $"column {column}, line {line}: the engine gives {fast}, ScalarRenderer {right[i]}";
        }
        return null;
    }

    /// <summary>The first pixel whose hit differs from the definition's, as a message; null if all are equal.</summary>
    public string? Difference(HitMap hits)
    {
        foreach (var (column, line) in pixels)
        {
            var (t, index) = hits[column, line];
            var ray = ScalarRenderer.Cast(scene, column, hits.Height - 1 - line);
            if (t != ray.HitParameter || (index < 0 ? null : scene.Models[index]) != ray.HitModel)
                return FormattableString.Invariant($"column {column}, line {line}: the engine gives t = {t:R}, ScalarRenderer {ray.HitParameter:R}");
        }
        return null;
    }
}
