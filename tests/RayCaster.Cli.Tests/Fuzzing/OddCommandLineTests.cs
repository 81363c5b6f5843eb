using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Fuzzing;

/// <summary>Any command line is run or refused in words.</summary>
public class OddCommandLineTests
{
    [Fact(Explicit = true)]
    public void OddCommandLinesDoNoHarm() =>
        Campaign.Run("command-line", 5000, OddCommandLine.Next, input => Understand(OddCommandLine.Words(input)));

    /// <summary>A sample through the real process, which leaves no temporary file.</summary>
    [Fact(Explicit = true)]
    public void OddCommandLinesEndInAPictureOrInWords()
    {
        using var raycaster = new RayCasterProcess();
        raycaster.Write("scene.json", """{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0], "width": 9, "height": 9 }, "models": [] }""");
        for (var i = 0; i < 8; i++)
        {
            raycaster.RunApart("", OddCommandLine.Words(OddCommandLine.Next(new Random(Campaign.Seed * 1000 + i))));
            Assert.Contains(raycaster.ExitCode, (int[])[0, 1, 2]);
            Promise.Wholesome(raycaster.Error.Replace("\r", ""));
            Assert.DoesNotContain(raycaster.Files, name => name.EndsWith(".tmp"));
        }
    }

    private static void Understand(string[] words)
    {
        try
        {
            var command = new CommandList().Find(words, out var rest);
            CommandLine.Parse(command.Name, command.Options, rest).Exactly("<one>", "<other>");
        }
        catch (ProblemException e)
        {
            Assert.DoesNotMatch("^$|^raycaster: ", e.Message); // the program's name is printed before it
            Assert.DoesNotContain("   at RayCaster", e.Message);
        }
    }
}
