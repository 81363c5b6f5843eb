using System.Runtime.Versioning;

namespace RayCaster.Files.Tests.Writing;

public sealed class ReplacedFileTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void ANewFileIsThereAfterCommit()
    {
        using (var file = new ReplacedFile(folder["room.png"]))
        {
            file.Write("new"u8);
            file.Commit();
        }
        Assert.Equal("new", File.ReadAllText(folder["room.png"]));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void AnOldFileIsReplacedByCommitAndNotBefore()
    {
        var path = folder.Write("room.png", "old and longer"u8);
        using var file = new ReplacedFile(path);
        file.Write("new"u8);
        file.Flush();
        Assert.Equal("old and longer", File.ReadAllText(path));
        file.Commit();
        Assert.Equal("new", File.ReadAllText(path));
    }

    [Fact]
    public void WhileItIsWrittenATemporaryFileStandsBesideIt()
    {
        using var file = new ReplacedFile(folder["room.png"]);
        Assert.Matches(@"^room\.png\.[0-9a-f]{8}\.tmp$", Assert.Single(folder.Names));
    }

    [Fact]
    public void WithoutCommitTheOldFileStaysAndNothingIsLeft()
    {
        var path = folder.Write("room.png", "old"u8);
        using (var file = new ReplacedFile(path)) file.Write(new byte[1_000_000]);
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void AnInterruptedPictureLeavesTheOldOneAndNothingElse()
    {
        var path = folder.Write("room.png", "old"u8);
        using (var file = new ReplacedFile(path))
        using (var writer = PictureWriter.Create(PictureFormat.Png, file, 1000, 1000))
        {
            writer.WriteRows(new byte[3000 * 500]);
            Assert.Throws<InvalidOperationException>(writer.Finish);
        }
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void APictureIsWrittenAndReadByItsName()
    {
        var picture = new Picture(2, 1);
        picture[1, 0] = (1, 2, 3);
        PictureFile.Write(folder["room.png"], picture);
        Assert.Equal([0, 0, 0, 1, 2, 3], PictureFile.Read(folder["room.png"]).Rgb);
    }

    [Fact]
    public void AFolderIsNotReplaced()
    {
        Directory.CreateDirectory(folder["room.png"]);
        Refused(folder["room.png"], $"cannot write {folder["room.png"]}: it is a folder; name a file in it");
    }

    [SkippableFact]
    public void ALinkIsReplacedAndNotFollowed()
    {
        Skip.If(OperatingSystem.IsWindows(), "needs special rights there");
        folder.Write("precious", "precious"u8);
        File.CreateSymbolicLink(folder["room.png"], folder["precious"]);
        using (var file = new ReplacedFile(folder["room.png"]))
        {
            file.Write("new"u8);
            file.Commit();
        }
        Assert.Equal(("precious", "new"), (File.ReadAllText(folder["precious"]), File.ReadAllText(folder["room.png"])));
        Assert.Null(new FileInfo(folder["room.png"]).LinkTarget);
    }

    [SkippableFact]
    public void ADeviceIsNotReplaced()
    {
        Skip.If(OperatingSystem.IsWindows(), "has no folder of devices");
        var refused = Assert.Throws<PictureFileException>(() => new ReplacedFile("/dev/raycaster-test")); // not a real one, should this fail
        Assert.Equal("cannot write /dev/raycaster-test: its folder is for devices, not for files", refused.Message);
    }

    /// <summary>The type of the file decides, not its name or its folder.</summary>
    [SkippableTheory]
    [InlineData("mknod room.png c 1 3")]
    [InlineData("mknod room.png b 7 200")]
    [InlineData("mkfifo room.png")]
    [InlineData("python3 -c \"import socket; socket.socket(socket.AF_UNIX).bind('room.png')\"")]
    [InlineData("ln -s /dev/null room.png")]
    [InlineData("ln -s nowhere room.png")]
    public void WhatIsNoFileIsNotReplaced(string make)
    {
        Skip.If(!OperatingSystem.IsLinux(), "Linux only");
        using (var shell = System.Diagnostics.Process.Start(
            new System.Diagnostics.ProcessStartInfo("sh", ["-c", make + " 2>/dev/null"]) { WorkingDirectory = folder.Path })!)
            shell.WaitForExit();
        Skip.If(!folder.Names.Any(), $"no right or no program for: {make}");
        Refused(folder["room.png"],
            $"cannot write {folder["room.png"]}: it is a device, a pipe or a socket, or a link to something else than a file; name a file");
    }

    [Fact]
    public void AnEmptyFileIsAFile()
    {
        using (var file = new ReplacedFile(folder.Write("room.png", ""u8)))
        {
            file.Write("new"u8);
            file.Commit();
        }
        Assert.Equal("new", File.ReadAllText(folder["room.png"]));
    }

    [SkippableFact]
    [UnsupportedOSPlatform("windows")] // rights are others there
    public void TheOldFilesRightsStay()
    {
        const UnixFileMode mine = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        File.SetUnixFileMode(folder.Write("room.png", "old"u8), mine);
        using var file = new ReplacedFile(folder["room.png"]);
        foreach (var name in folder.Names) Assert.Equal(mine, File.GetUnixFileMode(folder[name])); // the temporary one is no more open to others
        file.Commit();
        Assert.Equal(mine, File.GetUnixFileMode(folder["room.png"]));
    }

    [Theory]
    [InlineData(242, "x")]
    [InlineData(255, "x")]
    [InlineData(251, "\u00e4")]
    public void ANameMayBeAsLongAsTheSystemTakes(int bytes, string letter)
    {
        var name = string.Concat(Enumerable.Repeat(letter, (bytes - 4) / System.Text.Encoding.UTF8.GetByteCount(letter))) + ".png";
        using (var file = new ReplacedFile(folder[name]))
        {
            file.Write("new"u8);
            file.Commit();
        }
        Assert.Equal([name], folder.Names);
    }

    [Fact]
    public void AFolderThatIsNotThereIsNotMade()
    {
        var path = folder["a/room.png"];
        Refused(path, $"cannot write {path}: its folder does not exist\n  make the folder {folder["a"]} first", left: []);
    }

    [Fact]
    public void AReadOnlyFileIsNotReplaced()
    {
        var path = folder.Write("room.png", "old"u8);
        File.SetAttributes(path, FileAttributes.ReadOnly);
        Refused(path, $"cannot write {path}: the old file is read-only");
        File.SetAttributes(path, FileAttributes.Normal);
    }

    [Fact]
    public void AFileIsNotAFolder()
    {
        folder.Write("room.png", "old"u8);
        var path = folder["room.png/x.png"];
        Refused(path, $"cannot write {path}: its folder does not exist\n  make the folder {folder["room.png"]} first");
    }

    [Theory]
    [InlineData("", "'' is no file name")]
    [InlineData("a\0.png", @"'a\x00.png' is no file name")]
    public void AnImpossibleNameIsRefused(string path, string message)
    {
        Assert.Equal(message, Assert.Throws<PictureFileException>(() => new ReplacedFile(path)).Message);
        Assert.Equal(message, Assert.Throws<PictureFileException>(() => PictureFile.Read(path)).Message);
    }

    [Fact]
    public void ATooLongNameIsRefused()
    {
        var name = folder[new string('x', 300) + ".png"];
        Refused(name, $"cannot write {name}: the name is too long", left: []);
    }

    [Fact]
    public void AFailureAtTheEndLeavesNoTemporaryFile()
    {
        using (var file = new ReplacedFile(folder["room.png"]))
        {
            file.Write("new"u8);
            Directory.CreateDirectory(folder["room.png"]); // comes in between
            Assert.Throws<PictureFileException>(file.Commit);
        }
        Assert.Equal(["room.png"], folder.Names);
    }

    private void Refused(string path, string message, string[]? left = null)
    {
        Assert.Equal(message, Assert.Throws<PictureFileException>(() => new ReplacedFile(path)).Message);
        Assert.Equal(left ?? ["room.png"], folder.Names);
    }
}
