namespace RayCaster.Engine;

/// <summary>Draws pictures the fast way: tile by tile, several pixels at once, on several threads. Every bit is that of
/// <see cref="ScalarRenderer"/>.</summary>
public sealed class Renderer
{
    private readonly Scene scene;
    private readonly Camera camera;
    private readonly int threadCount;

    /// <param name="threads">How many threads cast rays, at least 1; one per core if left out.</param>
    public Renderer(Scene scene, int? threads = null)
    {
        (this.scene, camera, threadCount) = (scene, scene.Camera, threads ?? Environment.ProcessorCount);
        ArgumentOutOfRangeException.ThrowIfLessThan(threadCount, 1, nameof(threads));
    }

    /// <summary>
    /// Whether this process draws many pictures. Then the engine compiles the kernels of the float path, which takes as long as casting some ten
    /// million rays (without this option only a native program and a picture of as many pixels use them), and keeps what depends only on the list of
    /// models in memory, as long as the list lives: 48 bytes for each sphere. The list must not change between the pictures; colours may. It
    /// affects only time and memory.
    /// </summary>
    public bool ManyFrames { get; init; }

    internal Plan Plan => Plan.For(scene, threadCount, ManyFrames);

    /// <summary>Draws a whole picture in memory, which must not have more than 2³¹ bytes.</summary>
    /// <exception cref="EngineDisagreesException">A pixel differs from the definition.</exception>
    public static Picture Render(Scene scene, int? threads = null, CancellationToken cancellation = default)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        new Renderer(scene, threads).DrawInto(picture, cancellation);
        return picture;
    }

    /// <summary>Draws into an existing picture of the right size.</summary>
    /// <param name="cancellation">Stops the work with an <see cref="OperationCanceledException"/>.</param>
    /// <exception cref="EngineDisagreesException">A pixel differs from the definition.</exception>
    public void DrawInto(Picture picture, CancellationToken cancellation = default)
    {
        if ((picture.Width, picture.Height) != (camera.Width, camera.Height))
            throw new ArgumentException(
                $"a picture of {picture.Width} x {picture.Height} for one of {camera.Width} x {camera.Height}", nameof(picture));
        using var context = RenderContext.Of(scene, Plan, cancellation);
        var check = new DefinitionCheck(scene, 0, camera.Height, threadCount);
        check.RunAlongside(() =>
        {
            var shader = context.Shader; // before other threads need it
            Cast(context, cancellation, () =>
            {
                var consumer = new PictureConsumer(shader, picture.Width);
                consumer.SetTarget(picture.Rgb, picture.Height - 1);
                return consumer;
            });
        }, threadCount);
        check.Sample(picture.Rgb);
        EngineDisagreesException.ThrowIf(check.Difference());
    }

    /// <summary>Finds out what each pixel hits, and at which t.</summary>
    /// <param name="map">An existing map of the picture's size, to write into; a new one if left out.</param>
    /// <param name="cancellation">Stops the work with an <see cref="OperationCanceledException"/>.</param>
    /// <exception cref="EngineDisagreesException">A hit differs from the definition.</exception>
    public HitMap CastHits(HitMap? map = null, CancellationToken cancellation = default)
    {
        var hits = map ?? new(camera.Width, camera.Height);
        if ((hits.Width, hits.Height) != (camera.Width, camera.Height))
            throw new ArgumentException($"a map of {hits.Width} x {hits.Height} for a picture of {camera.Width} x {camera.Height}", nameof(map));
        using (var context = RenderContext.Of(scene, Plan, cancellation)) Cast(context, cancellation, () => context.HitsInto(hits));
        EngineDisagreesException.ThrowIf(new DefinitionCheck(scene, 0, camera.Height, threadCount).Difference(hits));
        return hits;
    }

    /// <summary>Draws the picture from top to bottom, some lines at a time, so that memory does not grow with its height.</summary>
    /// <param name="lines">Which lines, counted from the top: <c>..</c> for all.</param>
    /// <param name="write">Takes whole lines of red, green and blue bytes; called in order, one call at a time, on the thread that calls
    /// this.</param>
    /// <param name="linesDone">Called from any thread with the number of further lines that are done.</param>
    /// <param name="cancellation">Stops the work with an <see cref="OperationCanceledException"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">The picture has no such lines.</exception>
    /// <returns>Where a pixel differs from the definition, so that the lines are wrong; null if they are right.</returns>
    public string? Draw(Range lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone = null, CancellationToken cancellation = default)
    {
        var (first, end) = (lines.Start.GetOffset(camera.Height), lines.End.GetOffset(camera.Height));
        if (first < 0 || end > camera.Height || end <= first)
            throw new ArgumentOutOfRangeException(nameof(lines), lines, $"the picture has the lines 0..{camera.Height - 1}");
        using var context = RenderContext.Of(scene, Plan, cancellation);
        var check = new DefinitionCheck(scene, first, end, threadCount);
        check.RunAlongside(() =>
        {
            new BandQueue(context, first, end, threadCount, linesDone, cancellation).WriteAll(lines =>
            {
                check.Sample(lines);
                write(lines);
            });
        }, threadCount);
        return check.Difference();
    }

    /// <summary>Casts all rays, on this thread and others.</summary>
    private void Cast(RenderContext context, CancellationToken cancellation, Func<IHitConsumer> newConsumer)
    {
        var up = Tile.TilesOf(camera.Height);
        var width = Tile.StripWidth(camera.Width, up, threadCount);
        var across = (camera.Width + width - 1) / width;
        var workers = Math.Min(threadCount, across * up);
        var next = -1;
        ThreadTeam.Each(workers, workers, _ =>
        {
            var caster = context.NewCaster();
            var consumer = newConsumer();
            while (Interlocked.Increment(ref next) is var i && i < across * up)
            {
                cancellation.ThrowIfCancellationRequested();
                var (column, row) = (i % across * width, i / across * Tile.MaxSide);
                caster(new(column, row, Math.Min(width, camera.Width - column), Math.Min(Tile.MaxSide, camera.Height - row)), consumer);
            }
        });
    }
}

/// <summary>The engine's picture differs from the definition's: a fault of the engine, or of a formula that means something else over a packet of
/// numbers than over one number.</summary>
public sealed class EngineDisagreesException(string difference) : Exception($"the engine's picture is not the definition's at {difference}")
{
    /// <param name="difference">The pixel, and what both have there; null if they agree.</param>
    /// <exception cref="EngineDisagreesException">They do not.</exception>
    public static void ThrowIf(string? difference)
    {
        if (difference is not null) throw new EngineDisagreesException(difference);
    }
}
