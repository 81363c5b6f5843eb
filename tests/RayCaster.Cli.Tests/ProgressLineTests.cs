namespace RayCaster.Cli.Tests;

public class ProgressLineTests
{
    private readonly StringWriter terminal = new();
    private readonly Clock clock = new();

    private string[] Drawn => terminal.ToString().Split('\r', StringSplitOptions.RemoveEmptyEntries);

    [Fact]
    public void AShortRunDrawsNothing()
    {
        using (var line = new ProgressLine(terminal, "lines", clock))
        {
            clock.Now += TimeSpan.FromSeconds(0.49);
            for (var i = 0; i < 100; i++) line.LinesDone(1, 100);
        }
        Assert.Empty(terminal.ToString());
    }

    [Fact]
    public void ALongRunTellsHowFarItIsAndWipesItsLine()
    {
        using (var line = new ProgressLine(terminal, "lines", clock))
        {
            line.LinesDone(1, 4);
            clock.Now += TimeSpan.FromSeconds(2);
            line.LinesDone(1, 4);
        }
        Assert.Equal(" 50 %  2 of 4 lines  00:00:02 left", Drawn[0]);
        Assert.Equal([Drawn[0], new string(' ', Drawn[0].Length)], Drawn);
        Assert.EndsWith("\r", terminal.ToString());
    }

    /// <summary>A clock that the test sets.</summary>
    private sealed class Clock : TimeProvider
    {
        public TimeSpan Now { get; set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => Now.Ticks;
    }
}
