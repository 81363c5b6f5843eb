namespace RayCaster.Files.Tests.Writing;

/// <summary>The next writer deletes the files of killed writers, and no others.</summary>
public sealed class TemporaryFileTests : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void AnOrphanOfTheSameTargetGoes()
    {
        folder.Write("room.png.0123abcd.tmp", "what a killed writer left");
        using (new ReplacedFile(folder["room.png"])) Assert.False(File.Exists(folder["room.png.0123abcd.tmp"]));
        Assert.Empty(folder.Names);
    }

    /// <summary>However many files are written: what comes later is not searched for.</summary>
    [Fact]
    public void AListOfAFolderIsMadeOnce()
    {
        folder.Write("a.png.0123abcd.tmp", "what a killed writer left");
        new ReplacedFile(folder["a.png"]).Dispose();
        folder.Write("b.png.0123abcd.tmp", "what another leaves later");
        new ReplacedFile(folder["b.png"]).Dispose();
        Assert.Equal(["b.png.0123abcd.tmp"], folder.Names);
    }

    [Fact]
    public void WhatSomebodyWritesStays()
    {
        using var other = new ReplacedFile(folder["room.png"]);
        other.Write("theirs"u8);
        using (var mine = new ReplacedFile(folder["room.png"]))
        {
            mine.Write("mine"u8);
            mine.Commit();
        }
        Assert.Equal("mine", File.ReadAllText(folder["room.png"]));
        other.Commit();
        Assert.Equal("theirs", File.ReadAllText(folder["room.png"]));
        Assert.Equal(["room.png"], folder.Names);
    }

    [Theory]
    [InlineData("room.png.0123abcde.tmp")]
    [InlineData("room.png.0123abc.tmp")]
    [InlineData("room.png.0123abcg.tmp")]
    [InlineData("room.png.0123ABCD.tmp")]
    [InlineData("room.png.0123abcd.tmp2")]
    [InlineData("room.png-0123abcd.tmp")]
    [InlineData("room.png.0123abcd")]
    [InlineData("room.png.x.0123abcd.tmp")]
    [InlineData("aroom.png.0123abcd.tmp")]
    [InlineData("room.jpg.0123abcd.tmp")]
    public void AFileOfAnotherNameStays(string name)
    {
        folder.Write(name, "");
        new ReplacedFile(folder["room.png"]).Dispose();
        Assert.Equal([name], folder.Names);
    }

    [SkippableFact]
    public void AStarInTheTargetsNameStandsForItself()
    {
        Skip.If(OperatingSystem.IsWindows(), "no such names there");
        folder.Write("room.png.0123abcd.tmp", "");
        folder.Write("*.png.0123abcd.tmp", "");
        new ReplacedFile(folder["*.png"]).Dispose();
        Assert.Equal(["room.png.0123abcd.tmp"], folder.Names);
    }

    [Fact]
    public void AFolderOfSuchANameStays()
    {
        Directory.CreateDirectory(folder["room.png.0123abcd.tmp"]);
        new ReplacedFile(folder["room.png"]).Dispose();
        Assert.Equal(["room.png.0123abcd.tmp"], folder.Names);
    }

    [SkippableFact]
    public void OfALinkOfSuchANameOnlyTheLinkGoes()
    {
        Skip.If(OperatingSystem.IsWindows(), "needs special rights there");
        folder.Write("precious", "precious");
        File.CreateSymbolicLink(folder["room.png.0123abcd.tmp"], folder["precious"]);
        new ReplacedFile(folder["room.png"]).Dispose();
        Assert.Equal(["precious"], folder.Names);
        Assert.Equal("precious", File.ReadAllText(folder["precious"]));
    }

    /// <summary>Writers may find each other's files before they are locked: each must still finish its own.</summary>
    [Fact]
    public void ManyWritersOfOneTargetDoNotDisturbEachOther()
    {
        Parallel.For(0, 400, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
        {
            using var file = new ReplacedFile(folder["room.png"]);
            file.Write(BitConverter.GetBytes(i));
            if (i % 3 > 0) file.Commit();
        });
        Assert.Equal(["room.png"], folder.Names);
        Assert.Equal(4, File.ReadAllBytes(folder["room.png"]).Length);
    }
}
