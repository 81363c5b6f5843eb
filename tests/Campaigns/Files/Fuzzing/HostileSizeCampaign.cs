namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>Files that promise or hold far too much are refused by the header or by a limit that is named, before memory is taken for
/// them.</summary>
public sealed class HostileSizeCampaign : IDisposable
{
    private readonly TemporaryFolder folder = new();

    public void Dispose() => folder.Dispose();

    [Fact]
    public void AnEndlessMeshIsReadUpToTheLimit()
    {
        Assert.SkipWhen(!File.Exists("/dev/zero"), "no /dev/zero here");
        File.CreateSymbolicLink(folder["a.obj"], "/dev/zero");
        Assert.Equal($"{folder["a.obj"]}: the pipe or device has more than 268,435,456 bytes, which is the limit; a file may have any size",
            Assert.Throws<ProblemException>(() => MeshFile.Read(folder["a.obj"])).Message);
    }

    [Fact]
    public void ALineOfAGigabyteIsRefused()
    {
        var path = folder.Write("a.obj", "v 1 2 ");
        using (var file = new FileStream(path, FileMode.Open)) file.SetLength(1 << 30);
        Assert.Equal($"{path}(byte 0): a line or row begins here that has more than 268,435,456 bytes, which is the limit",
            Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }
}
