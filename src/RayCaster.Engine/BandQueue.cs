using System.Runtime.ExceptionServices;

namespace RayCaster.Engine;

/// <summary>Draws some lines of a picture in bands, from top to bottom: threads cast the strips of the next bands while finished bands are written
/// in order. Only a few bands are in memory at a time.</summary>
/// <remarks>
/// Threads take strips one after another over all bands, so that none waits at the end of a band. While the next band to write is not finished, the
/// writing thread casts strips, too; so one thread is enough. Another thread waits if there is no room for the next band until the oldest one is
/// written.
/// </remarks>
internal sealed class BandQueue
{
    private const int BytesOfBand = 1 << 24;

    private readonly RenderContext context;
    private readonly Camera camera;
    private readonly Action<int>? linesDone;
    private readonly CancellationToken cancellation;
    private readonly int rowsOfBand, stripWidth, stripsAcross, threadCount;
    private readonly int lowestRow, endRow; // of the lines to draw
    private readonly long bandCount, lowestBand;

    private readonly byte[][] buffers;
    private readonly object gate = new();   // guards all that follows
    private readonly int[] stripsMissing;   // of the band in each buffer
    private long nextStrip, bandsWritten;
    private ExceptionDispatchInfo? failure;

    /// <param name="linesDone">Called from any thread with the number of further lines that are done.</param>
    public BandQueue(RenderContext context, int firstLine, int endLine, int threads, Action<int>? linesDone, CancellationToken cancellation)
    {
        (this.context, camera) = (context, context.Scene.Camera);
        (this.linesDone, this.cancellation) = (linesDone, cancellation);

        // A band is a row of tiles (in very wide pictures a half, a quarter … of one), so that no tile lies in two bands.
        for (rowsOfBand = Tile.MaxSide; rowsOfBand > 1 && 3L * camera.Width * rowsOfBand > BytesOfBand;) rowsOfBand /= 2;
        (lowestRow, endRow) = (camera.Height - endLine, camera.Height - firstLine);
        lowestBand = lowestRow / rowsOfBand;
        bandCount = (endRow - 1) / rowsOfBand - lowestBand + 1;
        stripWidth = Tile.StripWidth(camera.Width, bandCount, threads);
        stripsAcross = (camera.Width + stripWidth - 1) / stripWidth;
        threadCount = (int)Math.Min(threads, bandCount * stripsAcross);
        buffers = new byte[threadCount == 1 ? 1 : Math.Min(bandCount, threads + 2)][];
        stripsMissing = new int[buffers.Length];
        for (var i = 0; i < buffers.Length; i++) (buffers[i], stripsMissing[i]) = (new byte[3 * camera.Width * rowsOfBand], stripsAcross);
    }

    public void WriteAll(Action<ReadOnlySpan<byte>> write)
    {
        var shader = context.Shader; // before other threads need it
        if (threadCount == 1) WriteAll(write, shader);
        else ThreadTeam.Help(threadCount - 1, () => Help(shader), () => WriteAll(write, shader));
    }

    private void WriteAll(Action<ReadOnlySpan<byte>> write, HitShader shader)
    {
        try
        {
            var caster = context.NewCaster();
            var consumer = new PictureConsumer(shader, camera.Width);
            for (var band = 0L; band < bandCount; band++)
            {
                while (NextFor(band) is >= 0 and var strip) Cast(strip, caster, consumer);
                write(buffers[band % buffers.Length].AsSpan(0, 3 * camera.Width * RowsOf(band).Height));
                Release(band);
            }
        }
        catch (Exception e)
        {
            Fail(e);
            throw;
        }
    }

    /// <summary>Casts strips on another thread until none is left.</summary>
    private void Help(HitShader shader)
    {
        try
        {
            var consumer = new PictureConsumer(shader, camera.Width);
            for (StripCaster? caster = null; Next() is >= 0 and var strip;) Cast(strip, caster ??= context.NewCaster(), consumer);
        }
        catch (Exception e)
        {
            Fail(e);
        }
    }

    private void Cast(long strip, StripCaster caster, PictureConsumer consumer)
    {
        var (band, column) = Math.DivRem(strip, stripsAcross);
        var (row, height) = RowsOf(band);
        var (left, buffer) = ((int)column * stripWidth, (int)(band % buffers.Length));
        consumer.SetTarget(buffers[buffer], row + height - 1);
        caster(new(left, row, Math.Min(stripWidth, camera.Width - left), height), consumer);
        lock (gate)
        {
            if (--stripsMissing[buffer] > 0) return;
            Monitor.PulseAll(gate);
        }
        linesDone?.Invoke(height);
    }

    /// <summary>The rows of a band; band 0 holds the first of the lines. The first and the last band may be cut.</summary>
    private (int Row, int Height) RowsOf(long band)
    {
        var row = (int)(lowestBand + bandCount - 1 - band) * rowsOfBand;
        var (first, end) = (Math.Max(row, lowestRow), Math.Min(row + rowsOfBand, endRow));
        return (first, end - first);
    }

    /// <summary>Whether there is a buffer for the band of the next strip.</summary>
    private bool HasRoom => nextStrip / stripsAcross < bandsWritten + buffers.Length;

    /// <summary>The next strip for a thread that only casts; waits for room. −1 if the work is over.</summary>
    private long Next()
    {
        lock (gate)
        {
            while (failure is null && nextStrip < bandCount * stripsAcross && !HasRoom) Monitor.Wait(gate);
            return failure is null && !cancellation.IsCancellationRequested && nextStrip < bandCount * stripsAcross ? nextStrip++ : -1;
        }
    }

    /// <summary>The next strip for the writing thread; −1 when the next band to write is finished. It waits only if others cast all strips for which
    /// there is room.</summary>
    private long NextFor(long band)
    {
        lock (gate)
        {
            while (true)
            {
                cancellation.ThrowIfCancellationRequested();
                failure?.Throw();
                if (stripsMissing[band % buffers.Length] == 0) return -1;
                if (nextStrip < bandCount * stripsAcross && HasRoom) return nextStrip++;
                Monitor.Wait(gate, TimeSpan.FromMilliseconds(50)); // then tests for cancellation
            }
        }
    }

    private void Release(long band)
    {
        lock (gate)
        {
            stripsMissing[band % buffers.Length] = stripsAcross;
            bandsWritten = band + 1;
            Monitor.PulseAll(gate);
        }
    }

    private void Fail(Exception e)
    {
        lock (gate)
        {
            failure ??= ExceptionDispatchInfo.Capture(e);
            Monitor.PulseAll(gate);
        }
    }
}
