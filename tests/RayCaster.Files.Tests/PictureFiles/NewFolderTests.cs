namespace RayCaster.Files.Tests.PictureFiles;

public sealed class NewFolderTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void ItIsThereAfterCommitAndNotBefore()
    {
        using (var made = new NewFolder(folder["lab"]))
        {
            File.WriteAllText(Path.Combine(made.Path, "a.txt"), "new");
            Assert.False(Directory.Exists(folder["lab"]));
            made.Commit();
        }
        Assert.Equal("new", File.ReadAllText(folder["lab/a.txt"]));
        Assert.Equal(["lab"], folder.Names);
    }

    [Fact]
    public void WithoutCommitNothingIsLeft()
    {
        using (var made = new NewFolder(folder["lab"])) File.WriteAllText(Path.Combine(made.Path, "a.txt"), "new");
        Assert.Empty(folder.Names);
    }

    [Fact]
    public void WhatKilledRunsHaveLeftGoesAndWhatAnotherRunWritesStays()
    {
        folder.Write("lab.0123abcd.tmp", "");
        Directory.CreateDirectory(folder["lab.0123abcd.dir/scenes"]);
        using var other = new NewFolder(folder["lab"]);
        Assert.False(Directory.Exists(folder["lab.0123abcd.dir"]));
        using (new NewFolder(folder["lab"])) Assert.True(Directory.Exists(other.Path));
        Assert.True(Directory.Exists(other.Path));
        other.Commit();
    }

    [Fact]
    public void OfALinkOfSuchANameOnlyTheLinkGoes()
    {
        if (OperatingSystem.IsWindows()) return; // needs special rights there
        folder.Write("lab.0123abcd.tmp", "");
        Directory.CreateDirectory(folder["precious"]);
        folder.Write("precious/a.txt", "precious");
        File.CreateSymbolicLink(folder["lab.0123abcd.dir"], folder["precious"]);
        new NewFolder(folder["lab"]).Dispose();
        Assert.Equal(["precious"], folder.Names);
        Assert.Equal("precious", File.ReadAllText(folder["precious/a.txt"]));
    }

    [Fact]
    public void AFolderThatIsNotEmptyStays()
    {
        using (var made = new NewFolder(folder["lab"]))
        {
            Directory.CreateDirectory(folder["lab/mine"]); // comes in between
            Assert.Throws<IOException>(made.Commit);
        }
        Assert.Equal(["lab"], folder.Names);
        Assert.True(Directory.Exists(folder["lab/mine"]));
    }
}
