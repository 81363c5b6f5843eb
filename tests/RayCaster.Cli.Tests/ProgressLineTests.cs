namespace RayCaster.Cli.Tests;

public class ProgressLineTests
{
    private readonly StringWriter terminal = new();
    private readonly Clock clock = new();

    private string[] Drawn => terminal.ToString().Split('\r', StringSplitOptions.RemoveEmptyEntries);

    [Fact]
    public void AShortRunDrawsNothing()
    {
        using (var line = new ProgressLine(terminal, 10, 100, 80, clock))
        {
            clock.Now += TimeSpan.FromSeconds(0.49);
            for (var i = 0; i < 100; i++) line.LinesDone(1);
        }
        Assert.Empty(terminal.ToString());
    }

    [Fact]
    public void ALongRunTellsHowFarItIsAndWipesItsLine()
    {
        using (var line = new ProgressLine(terminal, 1_000_000, 4, 80, clock))
        {
            line.LinesDone(1);
            clock.Now += TimeSpan.FromSeconds(2);
            line.LinesDone(1);
        }
        Assert.Equal(" 50 %  2 of 4 lines  1.0 million rays per second  00:00:02 left", Drawn[0]);
        Assert.Equal([Drawn[0], new string(' ', Drawn[0].Length)], Drawn);
        Assert.EndsWith("\r", terminal.ToString());
    }

    [Theory]
    [InlineData(2_500_000, "2.5 million rays per second")]
    [InlineData(100_000, "0.1 million rays per second")]
    [InlineData(99_999, "99,999 rays per second")]
    public void ASlowRunHasASpeed(double raysInASecond, string words) =>
        Assert.Equal(words, ProgressLine.Rate(raysInASecond * 2, "rays", TimeSpan.FromSeconds(2)));

    [Fact]
    public void ItIsDrawnTenTimesASecond()
    {
        using (var line = new ProgressLine(terminal, 1, 1000, 80, clock))
            for (var i = 0; i < 100; i++) // two seconds, of which the first half draws nothing
            {
                clock.Now += TimeSpan.FromSeconds(0.02);
                line.LinesDone(1);
            }
        Assert.Equal(16 + 1, Drawn.Length); // after 0.5, 0.6 … 2.0 seconds, and wiped
    }

    [Fact]
    public void TheTimeLeftMayBeDays()
    {
        using (var line = new ProgressLine(terminal, 1, 100_000, 80, clock))
        {
            clock.Now += TimeSpan.FromSeconds(3);
            line.LinesDone(1);
        }
        Assert.Contains("  83:19:57 left", Drawn[0]);
    }

    [Fact]
    public void ANarrowTerminalGetsANarrowLine()
    {
        using (var line = new ProgressLine(terminal, 1000, 4, 30, clock))
        {
            clock.Now += TimeSpan.FromSeconds(1);
            line.LinesDone(1);
        }
        Assert.All(Drawn, drawn => Assert.Equal(29, drawn.Length));
    }

    /// <summary>A clock that the test sets.</summary>
    private sealed class Clock : TimeProvider
    {
        public TimeSpan Now { get; set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => Now.Ticks;
    }
}
