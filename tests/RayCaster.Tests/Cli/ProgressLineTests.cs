using RayCaster.Cli;

namespace RayCaster.Tests.Cli;

public class ProgressLineTests
{
    [Fact]
    public void AShortRunDrawsNothing()
    {
        var terminal = new StringWriter();
        using (var line = new ProgressLine(terminal, 10, 100, 80))
            for (var i = 0; i < 100; i++) line.LinesDone(1);
        Assert.Empty(terminal.ToString());
    }

    [Fact]
    public void ALongRunTellsHowFarItIsAndWipesItsLine()
    {
        var terminal = new StringWriter();
        using (var line = new ProgressLine(terminal, 1000, 4, 80))
        {
            line.LinesDone(1);
            Thread.Sleep(TimeSpan.FromSeconds(0.7));
            line.LinesDone(1);
        }
        var drawn = terminal.ToString().Split('\r', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(2, drawn.Length);
        Assert.Matches(@"^ 50 %  2 of 4 lines  \d+\.\d million rays per second  00:00:0\d left$", drawn[0]);
        Assert.Equal(new string(' ', drawn[0].Length), drawn[1]);
        Assert.EndsWith("\r", terminal.ToString());
    }

    [Fact]
    public void ANarrowTerminalGetsANarrowLine()
    {
        var terminal = new StringWriter();
        using (var line = new ProgressLine(terminal, 1000, 4, 30))
        {
            Thread.Sleep(TimeSpan.FromSeconds(0.7));
            line.LinesDone(1);
        }
        Assert.All(terminal.ToString().Split('\r'), drawn => Assert.InRange(drawn.Length, 0, 29));
    }
}
