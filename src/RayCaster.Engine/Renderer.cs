namespace RayCaster.Engine;

/// <summary>Draws pictures the fast way: tile by tile, several pixels at once, on several threads. Every bit is that of
/// <see cref="ScalarRenderer"/>.</summary>
/// <param name="scene">What to draw.</param>
/// <param name="threads">How many threads cast rays; one per core if left out.</param>
public sealed class Renderer(Scene scene, int? threads = null)
{
    private readonly Camera camera = scene.Camera;
    private readonly int threadCount = threads ?? Environment.ProcessorCount;

    /// <summary>Whether a picture of little work is drawn without tiles; true unless said otherwise. The code for tiles takes longer to compile than
    /// such a picture takes to draw. Only the time depends on it.</summary>
    public bool MayBeSmall { get; init; } = true;

    /// <summary>Whether this process draws many pictures, so that the float path pays, whose kernels take as long to compile as casting some ten
    /// million rays. Without it only a picture of so many pixels uses them. Only the time depends on it.</summary>
    public bool ManyFrames { get; init; }

    /// <summary>Draws a whole picture in memory, which must not have more than 2³¹ bytes.</summary>
    public static Picture Render(Scene scene, int? threads = null)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        new Renderer(scene, threads).DrawInto(picture);
        return picture;
    }

    /// <summary>The same into a picture of the right size that is there already.</summary>
    public void DrawInto(Picture picture)
    {
        if ((picture.Width, picture.Height) != (camera.Width, camera.Height))
            throw new ArgumentException(
                $"a picture of {picture.Width} x {picture.Height} for one of {camera.Width} x {camera.Height}", nameof(picture));
        using var frame = Frame.Of(scene, threadCount, ManyFrames);
        var shader = frame.Shader; // made before other threads need it
        Cast(frame, () =>
        {
            var consumer = new PictureConsumer(shader, picture.Width);
            consumer.Enter(picture.Rgb, picture.Height - 1);
            return consumer;
        });
    }

    /// <summary>Finds out what each pixel hits, and at which t.</summary>
    public HitMap CastHits()
    {
        var hits = new HitMap(camera.Width, camera.Height);
        CastHits(hits);
        return hits;
    }

    /// <summary>The same into a map of the picture's size that is there already.</summary>
    public void CastHits(HitMap hits)
    {
        if ((hits.Width, hits.Height) != (camera.Width, camera.Height))
            throw new ArgumentException($"a map of {hits.Width} x {hits.Height} for a picture of {camera.Width} x {camera.Height}", nameof(hits));
        using var frame = Frame.Of(scene, threadCount, ManyFrames);
        Cast(frame, () => frame.HitsInto(hits));
    }

    /// <summary>Draws the picture from top to bottom, some lines at a time, so that memory does not grow with its height.</summary>
    /// <param name="write">Takes whole lines of red, green and blue bytes; called in order, one call at a time, on the thread that calls
    /// this.</param>
    /// <param name="linesDone">Told how many more lines have been cast, from any thread.</param>
    /// <param name="cancellation">Stops the work with an <see cref="OperationCanceledException"/>.</param>
    public void Draw(Action<ReadOnlySpan<byte>> write, Action<int>? linesDone = null, CancellationToken cancellation = default) =>
        Draw(0..camera.Height, write, linesDone, cancellation);

    /// <summary>Draws some lines of the picture, counted from the top, in the same way.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The picture has no such lines.</exception>
    public void Draw(Range lines, Action<ReadOnlySpan<byte>> write, Action<int>? linesDone = null, CancellationToken cancellation = default)
    {
        var (first, end) = (lines.Start.GetOffset(camera.Height), lines.End.GetOffset(camera.Height));
        if (first < 0 || end > camera.Height || end <= first)
            throw new ArgumentOutOfRangeException(nameof(lines), lines, $"the picture has the lines 0..{camera.Height - 1}");
        var isPlain = MayBeSmall && PlainWork.IsPlain(scene, end - first);
        var threads = isPlain && PlainWork.IsSmall(scene, end - first) ? 1 : threadCount;
        using var frame = Frame.Of(scene, threads, ManyFrames);
        new BandQueue(frame, first, end, threads, isPlain, linesDone, cancellation).WriteAll(write);
    }

    /// <summary>Casts all rays; this thread is one of those that do.</summary>
    private void Cast(Frame frame, Func<IHitConsumer> newSink)
    {
        var (across, up) = (Tile.StripsOf(camera.Width), Tile.TilesOf(camera.Height));
        var workers = Math.Min(threadCount, across * up);
        var next = -1;
        ThreadTeam.Each(workers, workers, _ =>
        {
            var (caster, consumer) = (frame.NewCaster(isPlain: false), newSink());
            while (Interlocked.Increment(ref next) is var i && i < across * up)
            {
                var (column, row) = (i % across * Tile.MaxStrip, i / across * Tile.MaxSide);
                caster.Cast(new(column, row, Math.Min(Tile.MaxStrip, camera.Width - column), Math.Min(Tile.MaxSide, camera.Height - row)), consumer);
            }
        });
    }
}
