using System.Diagnostics;
using System.Runtime.InteropServices;

namespace RayCaster.Benchmarks;

/// <summary>The ways of the engine.</summary>
internal static class OwnWays
{
    /// <summary>
    /// All ways. As the first of many frames, exact (the map is kept from run to run, as Embree's is) or only the bytes: all that is prepared for a
    /// scene is counted. As a later frame: the scene's models have been drawn before, from another side. As the program draws a single picture:
    /// in bands, which it writes one after another.
    /// </summary>
    public static IEnumerable<Way> All(BenchmarkScene scene, int width, int height)
    {
        var (map, picture) = (new Lazy<HitMap>(() => new(width, height)), new Lazy<Picture>(() => new(width, height)));
        foreach (var (suffix, next) in new[] { ("", (Func<Scene>)Fresh), (", later frame", Moving(scene, width, height)) })
        {
            yield return new($"exact t{suffix}", Answer.Hits, threads => Time(next(), threads,
                frame => new Renderer(frame, threads) { ManyFrames = true }.CastHits(map.Value)));
            yield return new($"bytes{suffix}", Answer.Bytes, threads => Time(next(), threads,
                frame => new Renderer(frame, threads) { ManyFrames = true }.DrawInto(picture.Value)));
        }
        yield return new("bytes of a single picture", Answer.Bytes, threads => Time(Fresh(), threads,
            frame => new Renderer(frame, threads).Draw(.., _ => { })));

        Scene Fresh()
        {
            var fresh = scene.Create(width, height);
            GC.Collect();
            return fresh;
        }
    }

    /// <summary>The same models in each frame, and a camera that swings by some degrees.</summary>
    private static Func<Scene> Moving(BenchmarkScene scene, int width, int height)
    {
        const int Frames = 16, OfOrbit = 720;
        var (kept, frame) = (new Lazy<Scene>(() => scene.Create(width, height)), 0);
        return () => kept.Value with { Camera = CameraMotion.Orbit(kept.Value.Camera, frame++ % Frames, OfOrbit) };
    }

    /// <summary>The milliseconds that work takes: on one thread its processor time, which other work of the machine hardly changes.</summary>
    private static double Time(Scene scene, int threads, Action<Scene> work)
    {
        if (threads == 1 && ProcessorTimeOfThread() is var before && !double.IsNaN(before))
        {
            work(scene);
            return ProcessorTimeOfThread() - before;
        }
        var start = Stopwatch.GetTimestamp();
        work(scene);
        return Stopwatch.GetElapsedTime(start).TotalMilliseconds;
    }

    /// <summary>The milliseconds that the processor has spent on this thread; NaN if the system does not tell.</summary>
    private static double ProcessorTimeOfThread()
    {
        const int ThreadCpuTime = 3;
        if (!OperatingSystem.IsLinux()) return double.NaN;
        var time = new long[2]; // seconds and nanoseconds
        return GetClock(ThreadCpuTime, time) == 0 ? time[0] * 1e3 + time[1] / 1e6 : double.NaN;
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int GetClock(int clock, long[] time);
}
