namespace RayCaster.Live.Tests;

/// <summary>Tests that measure the whole process, so that no other test may run in it.</summary>
[CollectionDefinition("alone", DisableParallelization = true)]
public class AloneCollection;

/// <summary>Memory does not grow with time.</summary>
[Collection("alone")]
public class MemoryTests
{
    [Fact]
    public async Task AThousandSavesTakeNoMoreMemoryThanAHundred()
    {
        await using var page = await LivePage.OpenAsync();
        await page.ConnectAsync();
        await page.FrameAsync();
        var before = 0L;
        for (var i = 1; i <= 1000; i++)
        {
            File.WriteAllText(page.Scene, LivePage.Ball.Replace("[6, 0, 2.5]", FormattableString.Invariant($"[{6 + 0.001 * i}, 0, 2.5]")));
            await page.FrameAsync();
            if (i == 100) before = Used();
        }
        var after = Used();
        Assert.True(after < 1.1 * before, $"{before} bytes after 100 saves, {after} after 1,000");
    }

    /// <summary>The process's memory after a collection.</summary>
    private static long Used()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        return Environment.WorkingSet;
    }
}
