namespace RayCaster.Cli.Tests;

/// <summary>The frames of orbit.</summary>
public sealed class FrameTests : CommandTests
{
    [Fact]
    public void AnOrbitIsNumberedFramesThatBeginWithTheScenesOwnPicture()
    {
        Directory.CreateDirectory(raycaster.PathOf("film"));
        raycaster.Run(Room, "-s", "20x15", "-o", "room.png").Run("orbit", Room, "--frames", "3", "-s", "20x15", "-o", "film");
        Assert.Matches(@"^film: 3 frames of 20 x 15 pixels drawn, 0 existed already, \d+\.\d\d s\n$", raycaster.Error);
        Assert.Equal(["room-0000.png", "room-0001.png", "room-0002.png"], Frames("film"));
        Assert.Equal(PictureFile.Read(raycaster.PathOf("room.png")).Rgb, PictureFile.Read(raycaster.PathOf("film/room-0000.png")).Rgb);
    }

    [Fact]
    public void FramesOfManyMachinesAreThoseOfOne()
    {
        foreach (var folder in (string[])["one", "many"]) Directory.CreateDirectory(raycaster.PathOf(folder));
        raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "-o", "one");
        foreach (var only in (string[])["2/2", "0..1"]) raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "-o", "many", "--only", only);
        Assert.Equal(Frames("one"), Frames("many"));
        foreach (var frame in Frames("one"))
            Assert.Equal(File.ReadAllBytes(raycaster.PathOf($"one/{frame}")), File.ReadAllBytes(raycaster.PathOf($"many/{frame}")));
    }

    [Fact]
    public void FramesThatAreThereAreLeftOut()
    {
        raycaster.Run("orbit", Room, "--frames", "4", "-s", "20x15");
        File.Delete(raycaster.PathOf("room-0002.png"));
        var before = File.GetLastWriteTimeUtc(raycaster.PathOf("room-0001.png"));
        raycaster.Run("orbit", Room, "--frames", "4", "-s", "20x15", "--resume");
        Assert.StartsWith(".: 1 frame of 20 x 15 pixels drawn, 3 existed already, ", raycaster.Error);
        Assert.Equal(before, File.GetLastWriteTimeUtc(raycaster.PathOf("room-0001.png")));
        raycaster.Run("orbit", Room, "--frames", "5", "-s", "20x15", "--resume"); // another film: only frame 0 is the same
        Assert.StartsWith("room-0001.png is drawn again: it shows another scene, another size or other lines\n" +
            ".: 4 frames of 20 x 15 pixels drawn, 1 existed already, ", raycaster.Error);
    }

    private IEnumerable<string> Frames(string folder) => Directory.GetFiles(raycaster.PathOf(folder)).Select(path => Path.GetFileName(path)).Order();
}
