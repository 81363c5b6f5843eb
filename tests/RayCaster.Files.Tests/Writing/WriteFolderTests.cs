namespace RayCaster.Files.Tests.Writing;

public sealed class WriteFolderTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void ItIsThereAtTheEndAndNotBefore()
    {
        WrittenFiles.WriteFolder(folder["lab"], made =>
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
        Assert.Throws<TimeoutException>(() => WrittenFiles.WriteFolder(folder["lab"], made =>
        {
            File.WriteAllText(Path.Combine(made, "a.txt"), "new");
            throw new TimeoutException();
        }));
        Assert.Empty(folder.Names);
    }

    [Fact]
    public void WhatKilledRunsHaveLeftGoesAndWhatAnotherRunWritesStays()
    {
        folder.Write("lab.0123abcd.tmp", "");
        Directory.CreateDirectory(folder["lab.0123abcd.dir/scenes"]);
        WrittenFiles.WriteFolder(folder["lab"], other =>
        {
            Assert.False(Directory.Exists(folder["lab.0123abcd.dir"]));
            Assert.Throws<TimeoutException>(() => WrittenFiles.WriteFolder(folder["lab"], _ =>
            {
                Assert.True(Directory.Exists(other));
                throw new TimeoutException();
            }));
            Assert.True(Directory.Exists(other));
        });
    }

    [SkippableFact]
    public void OfALinkOfSuchANameOnlyTheLinkGoes()
    {
        Skip.If(OperatingSystem.IsWindows(), "needs special rights there");
        folder.Write("lab.0123abcd.tmp", "");
        Directory.CreateDirectory(folder["precious"]);
        folder.Write("precious/a.txt", "precious");
        File.CreateSymbolicLink(folder["lab.0123abcd.dir"], folder["precious"]);
        WrittenFiles.WriteFolder(folder["lab"], _ => { });
        Assert.Equal(["lab", "precious"], folder.Names.Order());
        Assert.Equal("precious", File.ReadAllText(folder["precious/a.txt"]));
    }

    [Fact]
    public void AFolderThatIsNotEmptyStays()
    {
        Assert.Throws<PictureFileException>(() => WrittenFiles.WriteFolder(
            folder["lab"], _ => Directory.CreateDirectory(folder["lab/mine"]))); // comes in between
        Assert.Equal(["lab"], folder.Names);
        Assert.True(Directory.Exists(folder["lab/mine"]));
    }
}
