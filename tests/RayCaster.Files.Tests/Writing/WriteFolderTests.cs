namespace RayCaster.Files.Tests.Writing;

public sealed class WriteFolderTests : InTemporaryFolder
{
    [Fact]
    public void ItIsThereAtTheEndAndNotBefore()
    {
        AtomicFile.WriteFolder(folder["lab"], made =>
        {
            File.WriteAllText(Path.Combine(made, "a.txt"), "new");
            Assert.False(Directory.Exists(folder["lab"]));
        });
        Assert.Equal("new", File.ReadAllText(folder["lab/a.txt"]));
        Assert.Equal(["lab"], folder.Names);
    }

    [Fact]
    public void AfterAnErrorNothingIsLeft()
    {
        Assert.Throws<TimeoutException>(() => AtomicFile.WriteFolder(folder["lab"], made =>
        {
            File.WriteAllText(Path.Combine(made, "a.txt"), "new");
            throw new TimeoutException();
        }));
        Assert.Empty(folder.Names);
    }

    /// <summary>A shell may be in it, a link may lead to it, and beside a disk there is no place.</summary>
    [Theory]
    [InlineData("lab")]
    [InlineData("link")]
    public void AnEmptyFolderStaysAndIsFilled(string name)
    {
        const UnixFileMode Mine = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute;
        if (OperatingSystem.IsWindows()) Directory.CreateDirectory(folder["lab"]);
        else Directory.CreateDirectory(folder["lab"], Mine); // as no other is
        Assert.SkipWhen(name == "link" && OperatingSystem.IsWindows(), "links need special rights there");
        if (name == "link") Directory.CreateSymbolicLink(folder["link"], "lab");
        string[] before = [.. folder.Names];
        AtomicFile.WriteFolder(folder[name], made =>
        {
            Directory.CreateDirectory(Path.Combine(made, "deep"));
            File.WriteAllText(Path.Combine(made, "deep/a.txt"), "new");
            File.WriteAllText(Path.Combine(made, ".b"), "");
            Assert.Equal(before, folder.Names);
        });
        Assert.Equal(before, folder.Names);
        if (!OperatingSystem.IsWindows()) Assert.Equal(Mine, File.GetUnixFileMode(folder["lab"]));
        Assert.Equal([".b", "deep"], Directory.GetFileSystemEntries(folder["lab"]).Select(path => Path.GetFileName(path)).Order());
        Assert.Equal("new", File.ReadAllText(folder["lab/deep/a.txt"]));
    }

    [Fact]
    public void AnEmptyFolderThatGetsAnotherFileIsNotFilled()
    {
        Directory.CreateDirectory(folder["lab"]);
        var refused = Assert.Throws<ProblemException>(() => AtomicFile.WriteFolder(folder["lab"], made =>
        {
            File.WriteAllText(Path.Combine(made, "a.txt"), "new");
            folder.Write("lab/mine", ""u8);
        }));
        Assert.Equal($"cannot write the folder {folder["lab"]}: it is not empty", refused.Message);
        Assert.Equal([folder["lab/mine"]], Directory.GetFileSystemEntries(folder["lab"]));
    }

    [Fact]
    public void AFolderThatIsNotEmptyStays()
    {
        Assert.Throws<ProblemException>(() => AtomicFile.WriteFolder(
            folder["lab"], _ => Directory.CreateDirectory(folder["lab/mine"]))); // comes in between
        Assert.Equal(["lab"], folder.Names);
        Assert.True(Directory.Exists(folder["lab/mine"]));
    }
}
