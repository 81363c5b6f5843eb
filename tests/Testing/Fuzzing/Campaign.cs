using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Testing.Fuzzing;

/// <summary>
/// Many inputs, one after another, each made of a seed and a number, on a thread that is watched: an input that takes too long is a find like one
/// that
/// throws. RAYCASTER_SEED is the seed, RAYCASTER_MINUTES how long a campaign lasts (docs/limits.md); without them a fixed sample is tried.
/// </summary>
internal static class Campaign
{
    private static readonly TimeSpan MostTime = TimeSpan.FromSeconds(20); // of an input; it takes milliseconds, but the machine may be busy

    /// <summary>What everything random begins with.</summary>
    public static int Seed { get; } = (int)(Number("RAYCASTER_SEED") ?? 1);

    /// <summary>How long a campaign lasts; nothing for a sample.</summary>
    public static TimeSpan Time { get; } = TimeSpan.FromMinutes(Number("RAYCASTER_MINUTES") ?? 0);

    /// <summary>Tries inputs until one breaks a promise.</summary>
    /// <param name="name">Names the file of a find.</param>
    /// <param name="sample">How many inputs, where no time is given.</param>
    /// <param name="make">Makes an input.</param>
    /// <param name="attempt">Throws where something is wrong.</param>
    public static void Run(string name, int sample, Func<Random, SeedFile> make, Action<SeedFile> attempt)
    {
        var (count, input, started, failure) = (0L, default(SeedFile), Stopwatch.GetTimestamp(), default(Exception));
        var total = Stopwatch.StartNew();
        var worker = new Thread(() =>
        {
            while (failure is null && (count < sample || total.Elapsed < Time))
            {
                try
                {
                    var next = make(new Random(unchecked((int)(Seed * 1_000_003L + count))));
                    lock (total) (input, started) = (next, Stopwatch.GetTimestamp());
                    attempt(next);
                }
                catch (Exception e)
                {
                    failure = e;
                }
                if (failure is null) count++;
            }
        })
        { IsBackground = true };
        worker.Start();
        while (!worker.Join(100))
        {
            lock (total)
                if (Stopwatch.GetElapsedTime(started) > MostTime)
                    throw Find(new TimeoutException($"it takes more than {MostTime.TotalSeconds} s"));
        }
        if (failure is not null) throw Find(failure);
        if (Time > TimeSpan.Zero)
            File.AppendAllText(Path.Combine(Corpus.Kept, "campaign.received.txt"), $"{name}: {count:N0} inputs of seed {Seed}\n");

        Exception Find(Exception e)
        {
            var path = Path.Combine(Corpus.Kept, $"{name}-{Seed}-{count}.received{input.Extension}");
            File.WriteAllBytes(path, input.Bytes);
            return new InvalidOperationException(
                $"{e.GetType().Name}: {e.Message}\nThe input is {path}, of RAYCASTER_SEED={Seed}; " +
                    $"without \".received\" in its name it is a test for good.\n{e.StackTrace}", e);
        }
    }

    private static double? Number(string variable) =>
        double.TryParse(Environment.GetEnvironmentVariable(variable), CultureInfo.InvariantCulture, out var number) ? number : null;
}
