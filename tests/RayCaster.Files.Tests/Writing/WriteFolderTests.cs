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
    public void AFolderThatIsNotEmptyStays()
    {
        Assert.Throws<ProblemException>(() => WrittenFiles.WriteFolder(
            folder["lab"], _ => Directory.CreateDirectory(folder["lab/mine"]))); // comes in between
        Assert.Equal(["lab"], folder.Names);
        Assert.True(Directory.Exists(folder["lab/mine"]));
    }
}
