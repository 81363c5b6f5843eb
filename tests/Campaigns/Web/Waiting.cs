using System.Diagnostics;

namespace RayCaster.Web.Tests;

/// <summary>Waits for what the browser's own waiting cannot see.</summary>
internal static class Waiting
{
    private static readonly TimeSpan limit = TimeSpan.FromMinutes(2);

    public static Task UntilAsync(Func<bool> holds) => UntilAsync(() => Task.FromResult(holds()));

    public static async Task UntilAsync(Func<Task<bool>> holds)
    {
        var start = Stopwatch.GetTimestamp();
        while (!await holds())
        {
            if (Stopwatch.GetElapsedTime(start) > limit) throw new TimeoutException($"It does not hold after {limit.TotalSeconds} seconds.");
            await Task.Delay(20);
        }
    }
}
