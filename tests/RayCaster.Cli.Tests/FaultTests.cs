using System.Runtime.Versioning;

namespace RayCaster.Cli.Tests;

/// <summary>
/// What may go wrong around the real process: it ends by itself with a message and the right exit code, and what it leaves is the old picture or the
/// new one, whole. Where a fault cannot be made (no shell, no right to mount), its test is skipped.
/// </summary>
public sealed class FaultTests : CommandTests
{
    internal const string Old = "the old picture";

    [Theory(Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("room.ppm", "64k", "-q ROOM -s 999x999")]
    [InlineData("room.png", "8k", "-q ROOM -s 999x999")]
    public void AFullDiskLeavesTheOldPictureAndNothingElse(string file, string size, string command)
    {
        InOwnFileSystem($"mount -t tmpfs -o size={size} none disk; echo old >disk/{file}", $"raycaster {command} -o disk/{file}");
        Assert.Equal((2, $"raycaster: cannot write disk/{file}: the disk is full\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal($"{file} old\n", raycaster.OutputText);
    }

    [Fact(Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AReadOnlyFileSystemIsNamed()
    {
        InOwnFileSystem(
            "mount -t tmpfs none disk; echo old >disk/room.png; mount -o remount,ro disk", "raycaster -q ROOM -s 9x9 -o disk/room.png");
        Assert.Equal((2, "raycaster: cannot write disk/room.png: read-only file system\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal("room.png old\n", raycaster.OutputText);
    }

    [Fact(Skip = "has other rights", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [UnsupportedOSPlatform("windows")]
    public void AFolderOneMayNotWriteToIsNamed()
    {
        var folder = Environment.IsPrivilegedProcess ? "/proc" : "locked"; // no user may write to the first
        Directory.CreateDirectory(raycaster.PathOf("locked"), UnixFileMode.UserRead | UnixFileMode.UserExecute);
        raycaster.Run(Room, "-s", "9x9", "-o", folder + "/room.png");
        Assert.Equal((2, $"raycaster: cannot write {folder}/room.png: you may not write to its folder\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Theory(Skip = "has no such limit", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("room.ppm")]
    [InlineData("room.png")]
    public void ALimitOfFileSizesLeavesTheOldPictureAndNothingElse(string picture)
    {
        raycaster.Write(picture, Old);
        // The runtime's own large file of no content must not count.
        raycaster.RunInShell($"ulimit -f 8; export DOTNET_EnableWriteXorExecute=0; raycaster -q '{Room}' -s 1500x1500 -o {picture}");
        Assert.Equal((2, $"raycaster: cannot write {picture}: the file is larger than the system allows\n"), (raycaster.ExitCode, raycaster.Error));
        OnlyTheOldPicture(picture);
    }

    [Theory(Skip = "others have no such device, or other words", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData(">/dev/full", "No space left on device")]
    [InlineData(">&-", "it is closed")]
    public void AnOutputThatTakesNothingIsTold(string where, string reason)
    {
        raycaster.RunInShell($"{{ raycaster -q '{Room}' -s 3000x3000 -o -; echo $? >code; }} {where}");
        Assert.Equal($"raycaster: cannot write to standard output: {reason}\n", raycaster.Error);
        Assert.Equal("2\n", File.ReadAllText(raycaster.PathOf("code")));
    }

    [Trait("waits", "yes")]
    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AReaderThatHasStoppedDoesNotKeepOneFromCancelling()
    {
        using var process = raycaster.Start(Room, "-s", "3000x3000", "-o", "-");
        process.StandardOutput.BaseStream.ReadByte(); // the test reads no further, and the pipe is soon full
        Thread.Sleep(300);
        Assert.Equal(143, RayCasterProcess.Kill(process, "TERM"));
    }

    [Theory(Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData(24)]
    [InlineData(32)]
    [InlineData(48)]
    public void TooLittleMemoryIsTold(int megabytes)
    {
        raycaster.Write("wide.png", Old);
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={megabytes << 20:x}; raycaster '{Room}' -s 1000000x64 -t 2 -o wide.png");
        Assert.Equal((2, "raycaster: there is not enough memory\n"), (raycaster.ExitCode, raycaster.Error));
        OnlyTheOldPicture("wide.png");
    }

    [Fact(Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ADiagnosisWithTooLittleMemoryIsTold()
    {
        raycaster.Run(Room, "-q");
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={4 << 20:x}; raycaster diagnose '{Room}' room.png");
        Assert.Equal((2, "raycaster: there is not enough memory\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Trait("waits", "yes")]
    [Fact]
    public void AKilledRunLeavesTheOldPictureAndATemporaryFile()
    {
        raycaster.Write("room.png", Old);
        using (var process = raycaster.Start(Room, "--size", "20000x20000"))
        {
            WaitForTemporaryFile(process);
            process.Kill(); // SIGKILL: it has no time to tidy
            process.WaitForExit();
        }
        Assert.Matches(@"^room\.png room\.png\.[0-9a-f]{8}\.tmp$", string.Join(' ', raycaster.Files));
        Assert.Equal(Old, File.ReadAllText(raycaster.PathOf("room.png")));
        raycaster.Run(Room, "-s", "9x9");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.Equal(9, PictureFile.Read(raycaster.PathOf("room.png")).Width);
    }

    [Trait("waits", "yes")]
    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ARunDoesNotDisturbAnotherThatWritesTheSamePicture()
    {
        using var slow = raycaster.Start(Room, "--size", "20000x2000");
        WaitForTemporaryFile(slow);
        RayCasterProcess.Send(slow, "STOP"); // it goes on after the other has ended, however fast either is
        raycaster.Run(Room, "-s", "9x9");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.Equal(9, WidthOf("room.png"));
        RayCasterProcess.Send(slow, "CONT");
        slow.WaitForExit();
        Assert.Equal(0, slow.ExitCode);
        Assert.Equal(["room.png"], raycaster.Files);
        Assert.Equal(20000, WidthOf("room.png")); // the last to end has the say
    }

    private int WidthOf(string png)
    {
        using var picture = File.OpenRead(raycaster.PathOf(png));
        picture.Position = 18;
        return picture.ReadByte() << 8 | picture.ReadByte();
    }

    /// <summary>Runs the app beside a folder "disk" that is a file system of its own, which nobody else sees and which goes with the
    /// shell.</summary>
    private void InOwnFileSystem(string mount, string run)
    {
        Directory.CreateDirectory(raycaster.PathOf("disk"));
        var user = Environment.IsPrivilegedProcess ? "" : "-r"; // where the system allows it, one is root in a name space of one's own
        raycaster.Write("faulty.sh", $"""
            {mount} || exit 77
            {run.Replace("raycaster", "\"$1\"", StringComparison.Ordinal).Replace("ROOM", $"'{Room}'")}
            code=$?
            cd disk && for file in *; do echo "$file $(cat "$file")"; done
            exit $code
            """);
        raycaster.RunInShell($"unshare {user} -m true 2>/dev/null || exit 77; exec unshare {user} -m sh faulty.sh '{RayCasterProcess.App}'");
        Assert.SkipWhen(raycaster.ExitCode == 77, "no right to mount");
    }

    private void OnlyTheOldPicture(string name)
    {
        Assert.Equal([name], raycaster.Files);
        Assert.Equal(Old, File.ReadAllText(raycaster.PathOf(name)));
    }
}
