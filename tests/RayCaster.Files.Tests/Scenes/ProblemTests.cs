using System.Text;

namespace RayCaster.Files.Tests.Scenes;

public class ProblemTests
{
    [Fact]
    public void AProblemShowsItsLineWithTheValueUnderlined() => Assert.Equal(
        """
        room.json(2,10): error: camera.fovY must be a number, but is the text "45"; remove the quotes
            2 | 	"fovY":	"45", // degrees
              | 	       	^~~~
        """.ReplaceLineEndings("\n"),
        Read("{ \"camera\": { \"position\": [1, 0, 0], \"target\": [0, 0, 0],\r\n\t\"fovY\":\t\"45\", // degrees\r\n }, \"models\": [] }")
            .Problems[0].ToString());

    [Fact]
    public void OfALongLineOnlyWhatIsAroundTheValueIsShown()
    {
        var spaces = new string(' ', 500);
        var problem = Read($"{{ \"models\": [],{spaces}\"camera\": null{spaces}/* ü */ }}").Problems[0];
        var excerpt = problem.Excerpt.Split('\n');

        Assert.Equal((1, 1 + 15 + 500 + 10), (problem.Line, problem.Column));
        Assert.True(excerpt[0].Length < 140, excerpt[0]);
        Assert.Equal("null", excerpt[0].Substring(excerpt[1].IndexOf('^'), excerpt[1].Length - excerpt[1].IndexOf('^')));
    }

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    public void AnEmojiIsNotCutInTwo(string odd)
    {
        var emojis = string.Concat(Enumerable.Repeat("🎈", 200));
        var problems = Read($"{{ \"models\": [],{odd}/* {emojis} */\"camera\": \"{odd}{emojis}\", /* {emojis} */ \"camra\": null }}").Problems;

        Assert.All(problems, problem => Encoding.GetEncoding("utf-16", new EncoderExceptionFallback(), new DecoderExceptionFallback())
            .GetBytes(problem.ToString()));
        Assert.All(problems, problem => Assert.DoesNotContain('\uFFFD', problem.ToString()));
    }

    [Fact]
    public void WhatCouldMoveATerminalsCursorIsNotShown()
    {
        var report = Read("{ // \u001b[2J\n\"\u009b2J\": 1, /* \u001b[2J */ } x").Report();

        Assert.DoesNotContain(report, c => char.IsControl(c) && c != '\n');
    }

    [Fact]
    public void OfManyProblemsTwentyArePrinted()
    {
        var keys = string.Concat(Enumerable.Range(0, 23).Select(i => $"\"key{i}\": 0,\n"));
        var reading = Read($"{{ \"camera\": {{ \"position\": [1, 0, 0], \"target\": [0, 0, 0] }}, \"models\": [],\n{keys} }}");
        var report = reading.Report();

        Assert.Equal(23, reading.Problems.Count);
        Assert.Contains("key19 is an unknown key", report);
        Assert.DoesNotContain("key20 is an unknown key", report);
        Assert.EndsWith("\nand 3 more\n", report);
    }

    private static SceneReading Read(string text) => SceneReader.Parse(Encoding.UTF8.GetBytes(text), "room.json", ".");
}
