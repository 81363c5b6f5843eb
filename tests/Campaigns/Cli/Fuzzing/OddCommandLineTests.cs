using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Fuzzing;

/// <summary>Any command line is run or refused in words.</summary>
public class OddCommandLineTests
{
    [Fact]
    public void OddCommandLinesDoNoHarm() =>
        Campaign.Run("command-line", 5000, OddCommandLine.Next, input => Understand(OddCommandLine.Words(input)));

    private static void Understand(string[] words)
    {
        try
        {
            var line = CommandLine.Parse(words);
            line.PictureSize();
            line.ThreadCount();
            line.Exactly("<one>", "<other>");
        }
        catch (ProblemException e)
        {
            Assert.DoesNotMatch("^$|^raycaster: ", e.Message); // the program's name is printed before it
            Assert.DoesNotContain("   at RayCaster", e.Message);
        }
    }
}
