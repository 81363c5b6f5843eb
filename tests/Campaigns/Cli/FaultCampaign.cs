using System.Diagnostics;
using RayCaster.Testing.Fuzzing;
using static RayCaster.Cli.Tests.FaultTests;

namespace RayCaster.Cli.Tests;

/// <summary>
/// What may go wrong around the real process: it ends by itself with a message and the right exit code, and what it leaves is the old picture or the
/// new one, whole. Where a fault cannot be made (no shell, no right to mount), its test is skipped.
/// </summary>
[Trait("waits", "yes")]
public sealed class FaultCampaign : CommandTests
{
    /// <summary>From before its first instruction to after its last: whenever a signal comes, there is the old picture or the new one, and
    /// nothing else.</summary>
    [Theory]
    [InlineData("INT", 130)]
    [InlineData("TERM", 143)]
    public void ASignalAtAnyMomentLeavesAWholePicture(string signal, int exitCode)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "no kill command there");
        var random = new Random(Campaign.Seed);
        var until = Stopwatch.StartNew();
        for (var i = 0; i < 8 || until.Elapsed < Campaign.Time; i++)
        {
            raycaster.Write("room.png", Old);
            using var process = raycaster.Start("-q", Room, "-s", $"{1 + random.Next(1500)}x1000");
            Thread.Sleep(random.Next(350));
            var code = RayCasterProcess.Kill(process, signal);
            Assert.Contains(code, (int[])[0, exitCode]);
            Assert.Equal(["room.png"], raycaster.Files);
            if (code == 0 || File.ReadAllText(raycaster.PathOf("room.png")) != Old)
                Assert.Equal(1000, PictureFile.Read(raycaster.PathOf("room.png")).Height);
            Assert.DoesNotContain("   at ", process.StandardError.ReadToEnd());
        }
    }

    [Fact]
    public void AMeshThatShrinksOrVanishesWhileItIsReadIsNamed()
    {
        raycaster.Write(
            "mesh.json", """{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0] }, "models": [{ "type": "mesh", "file": "a.obj" }] }""");
        var text = string.Concat(Enumerable.Repeat("v 0 0 0\nv 1 0 0\nv 1 1 0.25\nf -1 -2 -3\n", 100_000));
        var random = new Random(Campaign.Seed);
        for (var i = 0; i < 6; i++)
        {
            raycaster.Write("a.obj", text);
            using var process = raycaster.Start("-q", "mesh.json", "-s", "9x9");
            Thread.Sleep(60 + random.Next(200));
            if (i % 3 == 0 && !OperatingSystem.IsWindows())
            {
                File.Delete(raycaster.PathOf("a.obj"));
            }
            else if (!OperatingSystem.IsWindows()) // there no process can shorten a file that another reads
            {
                using var file = new FileStream(raycaster.PathOf("a.obj"), FileMode.Open, FileAccess.Write, FileShare.ReadWrite);
                file.SetLength(random.Next((int)file.Length));
            }
            var error = process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.DoesNotContain("   at ", error);
            Assert.True(process.ExitCode == 0 || (process.ExitCode == 2 && error.Contains("a.obj")), $"exit code {process.ExitCode}: {error}");
        }
    }
}
