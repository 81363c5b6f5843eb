using System.Diagnostics;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests;

/// <summary>A signal ends every command within moments, whatever it reads, waits for or computes, and a line says which files are written. The
/// runtime's own answer to a signal has the same exit code, but no such line.</summary>
public sealed class InterruptionTests : CommandTests
{
    [Theory(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("HUP", 129)]
    [InlineData("INT", 130)]
    [InlineData("TERM", 143)]
    public void ASignalLeavesTheOldPictureAndNothingElse(string signal, int exitCode)
    {
        raycaster.Write("room.png", "the old picture");
        using var process = raycaster.Start(Room, "--size", "20000x20000");
        WaitForTemporaryFile(process);
        IsInterrupted(process, signal, exitCode);
        Assert.Equal(["room.png"], raycaster.Files);
        Assert.Equal("the old picture", File.ReadAllText(raycaster.PathOf("room.png")));
    }

    /// <summary>A second Ctrl-C neither ends the run sooner nor leaves a file.</summary>
    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ASecondSignalChangesNothing()
    {
        using var process = raycaster.Start(Room, "-s", "20000x20000");
        WaitForTemporaryFile(process);
        RayCasterProcess.Send(process, "INT");
        IsInterrupted(process, "INT", 130);
        Assert.Empty(raycaster.Files);
    }

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WhatWasWrittenBeforeIsNamed()
    {
        using var process = raycaster.Start("orbit", Room, "--frames", "100000", "-s", "60x40", "-q");
        WaitFor("the second frame", process, () => File.Exists(raycaster.PathOf("room-00001.png")));
        Assert.Equal(130, RayCasterProcess.Kill(process, "INT"));
        Assert.Matches(@"^raycaster: interrupted; \d+ files were written before, the last is room-\d+\.png; --resume continues\n$",
            process.StandardError.ReadToEnd());
        Assert.DoesNotContain(raycaster.Files, file => file.EndsWith(".tmp"));
        Assert.All(raycaster.Files, file => Assert.Equal(60, PictureFile.Read(raycaster.PathOf(file)).Width));
    }

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WaitingForASceneCanBeInterrupted()
    {
        using var process = raycaster.Start("-");
        process.StandardInput.Write(new string(' ', 1 << 20)); // more than a pipe takes: it has read
        process.StandardInput.Flush();
        IsInterrupted(process, "INT", 130);
    }

    /// <summary>All processes wait at the same time.</summary>
    [Fact(Explicit = true, Skip = "others may have no mkfifo", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ASignalEndsTheWaitForAPipe()
    {
        (string Signal, int ExitCode, string Arguments)[] cases =
        [
            ("INT", 130, "compare room.png pipe.png"),
            ("TERM", 143, "compare pipe.png room.png"),
            ("HUP", 129, "diagnose ROOM pipe.png"),
            ("INT", 130, "explain ROOM 1 1 --mine pipe.png"),
            ("HUP", 129, "stitch pipe.png -o whole.png"),
            ("TERM", 143, "part ROOM 1/1 --resume -o pipe.png"),
            ("INT", 130, "check pipe.png"),
        ];
        raycaster.Run(Room, "-s", "8x8", "-q");
        raycaster.RunInShell("mkfifo pipe.png");
        var waiting = cases.Select(test => raycaster.Start(Words(test.Arguments))).ToArray();
        Assert.All(cases.Zip(waiting), test =>
        {
            using var process = test.Second;
            WaitFor("a thread that opens a pipe", process, () => Directory.GetDirectories($"/proc/{process.Id}/task")
                .Any(task => File.ReadAllText(Path.Combine(task, "wchan")) == "wait_for_partner"));
            IsInterrupted(process, test.First.Signal, test.First.ExitCode);
        });
        Assert.Equal(["pipe.png", "room.png"], raycaster.Files);
    }

    [Theory(Explicit = true, Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("compare large.pgm other.pgm")]
    [InlineData("map ROOM t -s 10000x10000 -o room.ppm")]
    [InlineData("ROOM -s 30000x30000 -o room.ppm")]
    [InlineData("part ROOM 0..9999 -s 30000x30000 -o a.png")]
    public void ASignalEndsLongWork(string arguments)
    {
        var comparesFiles = arguments.StartsWith("compare", StringComparison.Ordinal);
        foreach (var (name, last) in comparesFiles ? ((string, byte)[])[("large.pgm", 0), ("other.pgm", 1)] : [])
        {
            using var file = File.Create(raycaster.PathOf(name));
            file.Write("P5 20000 20000 255\n"u8);
            file.SetLength(file.Length + 20000 * 20000 - 1);
            file.Position = file.Length;
            file.WriteByte(last);
        }
        using var process = raycaster.Start(Words(arguments));
        WaitFor("a second of work", process, () => !process.HasExited && process.TotalProcessorTime.TotalSeconds > 1);
        IsInterrupted(process, "INT", 130);
        Assert.Equal(comparesFiles ? ["large.pgm", "other.pgm"] : [], raycaster.Files);
    }

    /// <summary>From before its first instruction to after its last: whenever a signal comes, there is the old picture or the new one, and
    /// nothing else.</summary>
    [Theory(Explicit = true, Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("INT", 130)]
    [InlineData("TERM", 143)]
    public void ASignalAtAnyMomentLeavesAWholePicture(string signal, int exitCode)
    {
        var time = TimeOf("-q", Room, "-s", "1500x1000");
        var random = new Random(Campaign.Seed);
        var start = Stopwatch.GetTimestamp();
        for (var i = 0; i < 8 || Stopwatch.GetElapsedTime(start) < Campaign.Time; i++)
        {
            raycaster.Write("room.png", "the old picture");
            using var process = raycaster.Start("-q", Room, "-s", $"{1 + random.Next(1500)}x1000");
            Thread.Sleep(time * random.NextDouble());
            var code = RayCasterProcess.Kill(process, signal);
            Assert.Contains(code, (int[])[0, exitCode]);
            Assert.Equal(["room.png"], raycaster.Files);
            if (code == 0 || File.ReadAllText(raycaster.PathOf("room.png")) != "the old picture")
                Assert.Equal(1000, PictureFile.Read(raycaster.PathOf("room.png")).Height);
            Assert.DoesNotContain("   at ", process.StandardError.ReadToEnd());
        }
    }

    /// <summary>A progress line that cannot be drawn does not end a run: the exit code is that of the signal of the closed terminal.</summary>
    [Fact(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ATerminalThatIsClosedEndsTheRunAsItsSignalSays()
    {
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

    /// <summary>How long a command takes on this machine.</summary>
    private TimeSpan TimeOf(params string[] arguments)
    {
        var start = Stopwatch.GetTimestamp();
        raycaster.RunApart("", arguments);
        return Stopwatch.GetElapsedTime(start);
    }

    private static void IsInterrupted(Process process, string signal, int exitCode)
    {
        Assert.Equal(exitCode, RayCasterProcess.Kill(process, signal));
        Assert.EndsWith("raycaster: interrupted; nothing was written\n", process.StandardError.ReadToEnd());
    }
}
