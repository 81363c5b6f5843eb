namespace RayCaster.Live.Tests;

/// <summary>Tests that measure the whole process, so that no other test may run in it.</summary>
[CollectionDefinition("alone", DisableParallelization = true)]
public class AloneCollection;

/// <summary>Memory does not grow with time.</summary>
[Collection("alone")]
public class MemoryTests
{
    /// <summary>A save that left behind its picture, or what waits for its end, would leave some 5,000 bytes.</summary>
    [Fact(Explicit = true)]
    public async Task AThousandSavesTakeNoMoreMemoryThanAHundred()
    {
        await using var page = await LivePage.ShownAsync();
        var before = 0L;
        for (var i = 1; i <= 1000; i++)
        {
            File.WriteAllText(page.Scene, LivePage.Ball.Replace("[6, 0, 2.5]", FormattableString.Invariant($"[{6 + 0.001 * i}, 0, 2.5]")));
            await page.FrameAsync();
            if (i == 100) before = GC.GetTotalMemory(forceFullCollection: true);
        }
        var grown = GC.GetTotalMemory(forceFullCollection: true) - before;
        Assert.True(grown < 900 * 200, $"{grown} bytes more after 1,000 saves than after 100");
    }
}
