namespace RayCaster.Files.Tests.Scenes;

public class ShortFileTests
{
    [Fact]
    public void ALongFileIsReadUpToTheLimit()
    {
        using var folder = new TemporaryFolder();
        var path = folder.Write("rubric.json", new string(' ', ShortFile.MaxBytes + 1));
        Assert.Null(ShortFile.Read(path, "the rubric", _ => "read", out var report));
        Assert.Equal($"{path}: error: the file has more than 1,048,576 bytes, which is the limit\n", report);
    }
}
