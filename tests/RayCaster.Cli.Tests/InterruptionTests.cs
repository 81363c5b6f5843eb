using System.Diagnostics;

namespace RayCaster.Cli.Tests;

/// <summary>A signal ends every command within moments, whatever it reads, waits for or computes, and a line says which files are
/// written.</summary>
[Trait("waits", "yes")]
public sealed class InterruptionTests : CommandTests
{
    /// <summary>After this time a program reads or computes. If it does not yet, the runtime ends it with the same exit code.</summary>
    internal const int StartMilliseconds = 300;

    /// <summary>A second Ctrl-C neither ends the run sooner nor leaves a file.</summary>
    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ASecondSignalChangesNothing()
    {
        using var process = raycaster.Start(Room, "-s", "20000x20000");
        WaitForTemporaryFile(process);
        RayCasterProcess.Send(process, "INT");
        Assert.Equal(130, RayCasterProcess.Kill(process, "INT"));
        Assert.Equal("raycaster: interrupted; nothing was written\n", process.StandardError.ReadToEnd());
        Assert.Empty(raycaster.Files);
    }

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WhatWasWrittenBeforeIsNamed()
    {
        using var process = raycaster.Start("orbit", Room, "--frames", "1000", "-s", "500x500", "-q");
        while (!File.Exists(raycaster.PathOf("room-0001.png")) && !process.HasExited) Thread.Sleep(10);
        Assert.Equal(130, RayCasterProcess.Kill(process, "INT"));
        Assert.Matches(@"^raycaster: interrupted; \d+ files were written before, the last is room-\d+\.png; --resume continues\n$",
            process.StandardError.ReadToEnd());
        Assert.DoesNotContain(raycaster.Files, file => file.EndsWith(".tmp"));
        foreach (var file in raycaster.Files) Assert.Equal(500, PictureFile.Read(raycaster.PathOf(file)).Width);
    }

    internal static void IsInterrupted(Process process, string signal, int exitCode)
    {
        Assert.Equal(exitCode, RayCasterProcess.Kill(process, signal));
        Assert.Matches(@"(^|\n)raycaster: interrupted; nothing was written\n$|^$", process.StandardError.ReadToEnd());
    }

    internal static string[] Words(string arguments) => Array.ConvertAll(arguments.Split(' '), word => word == "ROOM" ? Room : word);
}
