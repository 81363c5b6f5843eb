using System.Runtime.Versioning;

namespace RayCaster.Files.Tests.Writing;

public sealed class WrittenFilesTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void ANewFileIsThereAtTheEndAndATemporaryOneBefore()
    {
        WrittenFiles.Write(folder["room.png"], file =>
        {
            file.Write("new"u8);
            Assert.Matches(@"^room\.png\.[0-9a-f]{8}\.tmp$", Assert.Single(folder.Names));
        });
        Assert.Equal("new", File.ReadAllText(folder["room.png"]));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void AnOldFileIsReplacedAtTheEndAndNotBefore()
    {
        var path = folder.Write("room.png", "old and longer"u8);
        WrittenFiles.Write(path, file =>
        {
            file.Write("new"u8);
            file.Flush();
            Assert.Equal("old and longer", File.ReadAllText(path));
        });
        Assert.Equal("new", File.ReadAllText(path));
    }

    [Fact]
    public void AfterAnErrorTheOldFileStaysAndNothingIsLeft()
    {
        var path = folder.Write("room.png", "old"u8);
        Assert.Throws<InvalidOperationException>(() => WrittenFiles.Write(path, file =>
        {
            using var writer = PictureWriter.Create(PictureFormat.Png, file, 1000, 1000);
            writer.WriteRows(new byte[3000 * 500]);
            writer.Finish();
        }));
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void AfterACancellationTheOldFileStaysAndNothingIsLeft()
    {
        var path = folder.Write("room.png", "old"u8);
        Assert.Throws<OperationCanceledException>(() => WrittenFiles.Write(path, file => file.Write("new"u8), new(canceled: true)));
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal(["room.png"], folder.Names);
    }

    /// <summary>An error of the drawing is not taken for one of the file.</summary>
    [Fact]
    public void AnErrorOfTheWriterStaysWhatItIs() => Assert.Throws<ArgumentOutOfRangeException>(
        () => WrittenFiles.Write(folder["room.png"], _ => throw new ArgumentOutOfRangeException("width")));

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

    [Fact]
    public void ALinkIsReplacedAndNotFollowed()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "needs special rights there");
        folder.Write("precious", "precious"u8);
        File.CreateSymbolicLink(folder["room.png"], folder["precious"]);
        Write("room.png");
        Assert.Equal(("precious", "new"), (File.ReadAllText(folder["precious"]), File.ReadAllText(folder["room.png"])));
        Assert.Null(new FileInfo(folder["room.png"]).LinkTarget);
    }

    [Fact]
    public void ADeviceIsNotReplaced()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "has no folder of devices");
        var refused = Assert.Throws<ProblemException>(() => WrittenFiles.Write("/dev/raycaster-test", _ => { })); // not a real one, should this fail
        Assert.Equal("cannot write /dev/raycaster-test: its folder is for devices, not for files", refused.Message);
    }

    [Fact]
    public void AnEmptyFileIsAFile()
    {
        folder.Write("room.png", ""u8);
        Write("room.png");
        Assert.Equal("new", File.ReadAllText(folder["room.png"]));
    }

    [Fact]
    [UnsupportedOSPlatform("windows")] // rights are others there
    public void TheOldFilesRightsStay()
    {
        const UnixFileMode mine = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        File.SetUnixFileMode(folder.Write("room.png", "old"u8), mine);
        // The temporary one is no more open to others.
        WrittenFiles.Write(folder["room.png"], _ => Assert.All(folder.Names, name => Assert.Equal(mine, new FileInfo(folder[name]).UnixFileMode)));
        Assert.Equal(mine, File.GetUnixFileMode(folder["room.png"]));
    }

    [Theory]
    [InlineData(242, "x")]
    [InlineData(255, "x")]
    [InlineData(251, "\u00e4")]
    public void ANameMayBeAsLongAsTheSystemTakes(int bytes, string letter)
    {
        var name = string.Concat(Enumerable.Repeat(letter, (bytes - 4) / System.Text.Encoding.UTF8.GetByteCount(letter))) + ".png";
        Write(name);
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
        Assert.Equal(message, Assert.Throws<ProblemException>(() => WrittenFiles.Write(path, _ => { })).Message);
        Assert.Equal(message, Assert.Throws<ProblemException>(() => PictureFile.Read(path)).Message);
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
        Assert.Throws<ProblemException>(() => WrittenFiles.Write(
            folder["room.png"], _ => Directory.CreateDirectory(folder["room.png"]))); // comes in between
        Assert.Equal(["room.png"], folder.Names);
    }

    [Fact]
    public void ManyWritersOfOneTargetDoNotDisturbEachOther()
    {
        Parallel.For(0, 400, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
        {
            var writing = Record.Exception(() => WrittenFiles.Write(folder["room.png"], file =>
            {
                file.Write(BitConverter.GetBytes(i));
                if (i % 3 == 0) throw new TimeoutException();
            }));
            Assert.Equal(i % 3 == 0, writing is not null);
        });
        Assert.Equal(["room.png"], folder.Names);
        Assert.Equal(4, File.ReadAllBytes(folder["room.png"]).Length);
    }

    private void Write(string name) => WrittenFiles.Write(folder[name], file => file.Write("new"u8));

    private void Refused(string path, string message, string[]? left = null)
    {
        Assert.Equal(message, Assert.Throws<ProblemException>(() => WrittenFiles.Write(path, _ => { })).Message);
        Assert.Equal(left ?? ["room.png"], folder.Names);
    }
}
