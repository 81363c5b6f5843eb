using static RayCaster.Cli.Tests.InterruptionTests;

namespace RayCaster.Cli.Tests;

/// <summary>A signal ends every command within moments, whatever it reads, waits for or computes, and a line says which files are
/// written.</summary>
[Trait("waits", "yes")]
public sealed class InterruptionCampaign : CommandTests
{
    /// <summary>All processes wait at the same time, so the test waits once.</summary>
    [Fact]
    public void ASignalEndsTheWaitForAPipe()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "others may have no mkfifo");
        (string Signal, int ExitCode, string Arguments)[] cases =
        [
            ("INT", 130, "compare room.png PIPE"),
            ("TERM", 143, "compare PIPE room.png"),
            ("HUP", 129, "diagnose ROOM PIPE"),
            ("INT", 130, "explain ROOM 1 1 --reference PIPE"),
            ("HUP", 129, "stitch PIPE -o whole.png"),
            ("TERM", 143, "part ROOM 1/1 --resume -o PIPE"),
            ("INT", 130, "check PIPE"),
        ];
        raycaster.Run(Room, "-s", "8x8", "-q");
        raycaster.RunInShell("mkfifo pipe.png");
        var waiting = cases.Select(test => raycaster.Start(Words(test.Arguments.Replace("PIPE", "pipe.png")))).ToArray();
        Thread.Sleep(StartMilliseconds * 2);
        Assert.All(cases.Zip(waiting), test =>
        {
            using var process = test.Second;
            IsInterrupted(process, test.First.Signal, test.First.ExitCode);
        });
        Assert.Equal(["pipe.png", "room.png"], raycaster.Files);
    }

    [Theory]
    [InlineData("compare large.pbm other.pbm --measures")]
    [InlineData("map ROOM t -s 10000x10000 -o room.pfm")]
    [InlineData("ROOM -s 30000x30000 -o room.ppm")]
    [InlineData("part ROOM 0..9999 -s 30000x30000 -o a.png")]
    public void ASignalEndsLongWork(string arguments)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "no kill command there");
        var comparesFiles = arguments.StartsWith("compare", StringComparison.Ordinal);
        foreach (var (name, last) in comparesFiles ? ((string, byte)[])[("large.pbm", 0), ("other.pbm", 1)] : [])
        {
            using var file = File.Create(raycaster.PathOf(name));
            file.Write("P4 20000 20000\n"u8);
            file.SetLength(file.Length + 2500 * 20000 - 1);
            file.Position = file.Length;
            file.WriteByte(last);
        }
        using var process = raycaster.Start(Words(arguments));
        Thread.Sleep(StartMilliseconds);
        IsInterrupted(process, "INT", 130);
        Assert.Equal(comparesFiles ? ["large.pbm", "other.pbm"] : [], raycaster.Files);
    }

    [Theory]
    [InlineData("stitch parts -o film.png -q")]
    [InlineData("compare frames/room-0000.png frames/room-0001.png -o film.png")]
    public void AKillLeavesAWholePicture(string arguments)
    {
        Directory.CreateDirectory(raycaster.PathOf("frames"));
        Directory.CreateDirectory(raycaster.PathOf("parts"));
        raycaster.Run("orbit", Room, "--frames", "6", "-s", "400x400", "-o", "frames", "-q");
        foreach (var part in (ReadOnlySpan<string>)["1/2", "2/2"])
            raycaster.Run("part", Room, part, "-s", "1500x1500", "-o", $"parts/{part[0]}.png", "-q");
        var random = new Random(RayCaster.Testing.Fuzzing.Campaign.Seed);
        for (var i = 0; i < 3; i++)
        {
            using var process = raycaster.Start(Words(arguments));
            Thread.Sleep(150 + random.Next(500));
            process.Kill();
            process.WaitForExit();
            if (File.Exists(raycaster.PathOf("film.png"))) Assert.NotEqual(0, PictureFile.Read(raycaster.PathOf("film.png")).Width);
        }
        raycaster.Run(Words(arguments));
        Assert.NotEqual(2, raycaster.ExitCode);
        Assert.Equal(["film.png", "frames", "parts"], raycaster.Files.Where(file => !file.EndsWith(".tmp")));
    }

    /// <summary>A progress line that cannot be drawn does not end a run: the exit code is that of the signal of the closed terminal.</summary>
    [Fact]
    public void ATerminalThatIsClosedEndsTheRunAsItsSignalSays()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Linux only");
        raycaster.Write("terminal.py", """
            import os, pty, select, sys, time
            child, terminal = pty.fork()
            if child == 0:
                os.environ.pop('CI', None)
                os.environ['TERM'] = 'xterm'
                os.execv(sys.argv[1], sys.argv[1:])
            end, shown = time.time() + 60, b''
            while b'%' not in shown and time.time() < end: # the line is drawn after half a second, and ten times in each
                if select.select([terminal], [], [], 0.1)[0]: shown += os.read(terminal, 1000)
            os.close(terminal)
            print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
            """);
        raycaster.RunInShell($"command -v python3 >/dev/null || exit 77; python3 terminal.py '{RayCasterProcess.App}' '{Room}' -s 30000x30000");
        Assert.SkipWhen(raycaster.ExitCode == 77, "python3 is missing");
        Assert.Equal(("129\n", ""), (raycaster.OutputText, raycaster.Error));
        Assert.Equal(["terminal.py"], raycaster.Files);
    }
}
