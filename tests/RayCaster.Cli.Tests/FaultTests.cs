using System.Runtime.Versioning;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests;

/// <summary>
/// What may go wrong around the real process: it ends by itself with a message and the right exit code, and what it leaves is the old picture or the
/// new one, whole. Where a fault cannot be made (no shell, no right to mount), its test is skipped.
/// </summary>
public sealed class FaultTests : CommandTests
{
    private const string Old = "the old picture";

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
        raycaster.RunInShell($"ulimit -f 8; export DOTNET_EnableWriteXorExecute=0; raycaster -q '{Room}' -s 500x500 -o {picture}");
        Assert.Equal((2, $"raycaster: cannot write {picture}: the file is larger than the system allows\n"), (raycaster.ExitCode, raycaster.Error));
        OnlyTheOldPicture(picture);
    }

    [Theory(Skip = "others have no such device, or other words", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData(">/dev/full", "No space left on device")]
    [InlineData(">&-", "it is closed")]
    public void AnOutputThatTakesNothingIsTold(string where, string reason)
    {
        raycaster.RunInShell($"{{ raycaster -q '{Room}' -s 300x300 -o -; echo $? >code; }} {where}");
        Assert.Equal($"raycaster: cannot write to standard output: {reason}\n", raycaster.Error);
        Assert.Equal("2\n", File.ReadAllText(raycaster.PathOf("code")));
    }

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AReaderThatHasStoppedDoesNotKeepOneFromCancelling()
    {
        using var process = raycaster.Start(Room, "-s", "1000x1000", "-o", "-");
        process.StandardOutput.BaseStream.ReadByte(); // the test reads no further
        var spent = TimeSpan.Zero;
        WaitFor("the end of its work, as the pipe is full", process, () =>
        {
            Thread.Sleep(100);
            var before = spent;
            spent = process.TotalProcessorTime;
            return spent == before;
        });
        Assert.Equal(143, RayCasterProcess.Kill(process, "TERM"));
    }

    [Fact(Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void TooLittleMemoryIsTold()
    {
        raycaster.Write("wide.png", Old);
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={32 << 20:x}; raycaster '{Room}' -s 1000000x64 -t 2 -o wide.png");
        Assert.Equal((2, "raycaster: there is not enough memory\n"), (raycaster.ExitCode, raycaster.Error));
        OnlyTheOldPicture("wide.png");
    }

    [Fact(Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ADiagnosisWithTooLittleMemoryIsTold()
    {
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={4 << 20:x}; raycaster diagnose '{Room}' '{ProjectFolder.PathOf("docs/room.png")}'");
        Assert.Equal((2, "raycaster: there is not enough memory\n"), (raycaster.ExitCode, raycaster.Error));
    }

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

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ARunDoesNotDisturbAnotherThatWritesTheSamePicture()
    {
        using var slow = raycaster.Start(Room, "--size", "20000x1000", "-t", "1");
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

    /// <summary>One filter for each mesh and thread would take gigabytes here.</summary>
    [Fact(Explicit = true, Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AThousandMeshesFitIntoLittleMemory()
    {
        raycaster.Write("cube.obj",
            "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n" +
            "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        var random = new Random(1);
        var models = string.Join(",\n", Enumerable.Range(0, 1000).Select(_ => FormattableString.Invariant(
            $$"""{ "type": "mesh", "file": "cube.obj", "translate": [{{random.Next(-8, 8)}}, {{random.Next(-8, 8)}}, {{random.Next(-8, 8)}}] }""")));
        raycaster.Write("many.json",
            $$"""{ "camera": { "position": [30, 0, 0], "target": [0, 0, 0], "width": 1000, "height": 1000 }, "models": [ {{models}} ] }""");
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={100 << 20:x}; raycaster many.json -t 8 -q");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }

    [Theory(Explicit = true, Skip = "no /dev/zero there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("-")]
    [InlineData("/dev/zero")]
    public void AnEndlessSceneIsReadUpToTheLimit(string scene)
    {
        raycaster.RunInShell($"raycaster {scene} </dev/zero");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.EndsWith(
            ": error: the scene file has more than 67,108,864 bytes, which is the limit; put large meshes into mesh files\n", raycaster.Error);
        Assert.Empty(raycaster.Files);
    }

    [Fact(Explicit = true, Skip = "no process can shorten a file that another reads", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
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
            var work = TimeSpan.FromSeconds(0.06 + 0.2 * random.NextDouble());
            while (!process.HasExited && process.TotalProcessorTime < work) Thread.Sleep(1);
            if (i % 3 == 0) File.Delete(raycaster.PathOf("a.obj"));
            else
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
