namespace RayCaster.Engine;

/// <summary>
/// Draws some lines of a picture in bands, from top to bottom: several threads cast the tiles of the next bands while the finished ones are written in order.
/// Only a few bands are in memory at a time.
/// </summary>
/// <remarks>
/// Strips of tiles are handed out one after another over all bands, so no thread waits at the end of a band. A thread that comes to a band for which there is no room
/// waits until the oldest one is written.
/// </remarks>
internal sealed class BandQueue
{
    private const int BytesOfBand = 1 << 24;

    private readonly Frame frame;
    private readonly Camera camera;
    private readonly SpanShader shader;
    private readonly Action<int>? linesDone;
    private readonly CancellationToken cancellation;
    private readonly bool isPlain;
    private readonly int rowsOfBand, stripsAcross, threadCount;
    private readonly int lowestRow, endRow;  // of the lines to draw
    private readonly long bandCount, lowestBand;

    private readonly byte[][] buffers;
    private readonly int[] stripsMissing;     // of the band in each buffer
    private long nextStrip;
    private long bandsWritten;               // guarded by the lock on buffers, as stripsMissing and failure are
    private Exception? failure;

    /// <param name="frame">What to draw; disposed of when it is drawn.</param>
    /// <param name="firstLine">The first line, counted from the top.</param>
    /// <param name="endLine">The line after the last.</param>
    /// <param name="threads">How many threads cast.</param>
    /// <param name="isPlain">Whether every ray may as well meet every model.</param>
    /// <param name="linesDone">Told how many lines have been cast, from any thread.</param>
    /// <param name="cancellation">Stops the work.</param>
    public BandQueue(Frame frame, int firstLine, int endLine, int threads, bool isPlain, Action<int>? linesDone, CancellationToken cancellation)
    {
        (this.frame, camera) = (frame, frame.Scene.Camera);
        this.isPlain = isPlain && !frame.IsLong && frame.Crowd is null;
        shader = frame.Shader;
        (this.linesDone, this.cancellation) = (linesDone, cancellation);

        // A band is a row of tiles, or of very wide pictures a half, a quarter … of one, so that no tile lies in two bands.
        for (rowsOfBand = Tile.MaxSide; rowsOfBand > 1 && 3L * camera.Width * rowsOfBand > BytesOfBand;) rowsOfBand /= 2;
        stripsAcross = Tile.StripsOf(camera.Width);
        (lowestRow, endRow) = (camera.Height - endLine, camera.Height - firstLine);
        lowestBand = lowestRow / rowsOfBand;
        bandCount = (endRow - 1) / rowsOfBand - lowestBand + 1;
        buffers = new byte[Math.Min(bandCount, threads + 2)][];
        stripsMissing = new int[buffers.Length];
        for (var i = 0; i < buffers.Length; i++) (buffers[i], stripsMissing[i]) = (new byte[3 * camera.Width * rowsOfBand], stripsAcross);
        threadCount = (int)Math.Min(threads, bandCount * stripsAcross);
    }

    /// <summary>Draws it all.</summary>
    /// <param name="write">Takes whole lines, in order, on this thread.</param>
    public void WriteAll(Action<ReadOnlySpan<byte>> write)
    {
        var workers = new List<Thread>(threadCount);
        try
        {
            while (workers.Count < threadCount)
            {
                var worker = new Thread(Work) { IsBackground = true, Name = "caster" };
                worker.Start(); // if it throws, those who have begun are sent home
                workers.Add(worker);
            }
            for (var band = 0L; band < bandCount; band++)
            {
                var buffer = WaitForBand(band);
                write(buffer.AsSpan(0, 3 * camera.Width * RowsOf(band).Height));
                Release(band);
            }
        }
        catch (Exception e)
        {
            Fail(e);
            throw;
        }
        finally
        {
            foreach (var worker in workers) worker.Join();
            frame.Dispose();
        }
    }

    /// <summary>The rows of a band; band 0 holds the first of the lines. The first and the last band may be cut.</summary>
    private (int Row, int Height) RowsOf(long band)
    {
        var row = (int)(lowestBand + bandCount - 1 - band) * rowsOfBand;
        var (first, end) = (Math.Max(row, lowestRow), Math.Min(row + rowsOfBand, endRow));
        return (first, end - first);
    }

    private void Work()
    {
        try
        {
            var caster = isPlain ? new PlainCaster(camera, Array.ConvertAll(frame.Views, view => view.ForThread())) : NewTileCaster();
            while (true)
            {
                var strip = Interlocked.Increment(ref nextStrip) - 1;
                var (band, column) = Math.DivRem(strip, stripsAcross);
                if (band >= bandCount || !WaitForRoom(band)) return;
                var (row, height) = RowsOf(band);
                var (left, buffer) = ((int)column * Tile.MaxStrip, (int)(band % buffers.Length));
                var sink = new PictureSink(shader, buffers[buffer], camera.Width, row + height - 1);
                caster.Cast(new(left, row, Math.Min(Tile.MaxStrip, camera.Width - left), height), sink);
                StripDone(buffer, height);
            }
        }
        catch (Exception e)
        {
            Fail(e);
        }
    }

    /// <remarks>By itself, so that a tile caster is not even loaded where none is needed.</remarks>
    private IStripCaster NewTileCaster() => new TileCaster(frame);

    /// <summary>Waits until the band before the last that used the same buffer is written; false if the work is off.</summary>
    private bool WaitForRoom(long band)
    {
        lock (buffers)
        {
            while (failure is null && band >= bandsWritten + buffers.Length) Monitor.Wait(buffers);
            return failure is null && !cancellation.IsCancellationRequested;
        }
    }

    private void StripDone(int buffer, int lines)
    {
        lock (buffers)
        {
            if (--stripsMissing[buffer] > 0) return;
            Monitor.PulseAll(buffers);
        }
        linesDone?.Invoke(lines);
    }

    private byte[] WaitForBand(long band)
    {
        var buffer = band % buffers.Length;
        lock (buffers)
        {
            while (failure is null && stripsMissing[buffer] > 0)
            {
                cancellation.ThrowIfCancellationRequested();
                Monitor.Wait(buffers, TimeSpan.FromMilliseconds(50)); // looks up now and then whether it is cancelled
            }
            if (failure is not null) throw failure;
        }
        cancellation.ThrowIfCancellationRequested();
        return buffers[buffer];
    }

    private void Release(long band)
    {
        lock (buffers)
        {
            stripsMissing[band % buffers.Length] = stripsAcross;
            bandsWritten = band + 1;
            Monitor.PulseAll(buffers);
        }
    }

    private void Fail(Exception e)
    {
        lock (buffers)
        {
            failure ??= e;
            Monitor.PulseAll(buffers);
        }
    }
}
