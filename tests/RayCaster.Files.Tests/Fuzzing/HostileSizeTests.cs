using System.IO.Compression;
using System.Text;
using static RayCaster.Files.Tests.Pictures.TestPng;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>Files that promise or hold far too much are refused by the header or by a limit that is named, before memory is taken for
/// them.</summary>
[Collection(Alone.Name)]
public sealed class HostileSizeTests : InTemporaryFolder
{

    public HostileSizeTests() => GC.Collect(); // what the tests before have left: some of these take much by themselves

    [Theory]
    [InlineData("ascii", "9")]
    [InlineData("ascii", "4294967296")]
    [InlineData("binary_little_endian", "4294967296")]
    [InlineData("binary_big_endian", "9223372036854775807")]
    public void MoreVerticesThanTheFileCanHoldAreNotBelieved(string format, string count)
    {
        var file = $"ply\nformat {format} 1.0\nelement vertex {count}\nproperty float x\nproperty float y\nproperty float z\n"
            + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
        Assert.Contains("the file ends before all that its header promises", RefusedMesh("a.ply", Encoding.ASCII.GetBytes(file)));
    }

    [Fact]
    public void FourBillionCornersAreNotBelieved()
    {
        var file = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\n"
            + "element face 1\nproperty list uint int vertex_indices\nend_header\n";
        byte[] bytes = [.. Encoding.ASCII.GetBytes(file), 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, .. new byte[20]];
        Assert.Contains("the file ends before all that its header promises", RefusedMesh("a.ply", bytes));
    }

    [Fact]
    public void ADecompressionBombIsOnlyReadAsFarAsItsPixelsGo()
    {
        var bomb = new MemoryStream();
        using (var zlib = new ZLibStream(bomb, CompressionLevel.SmallestSize, leaveOpen: true))
            for (var i = 0; i < 20; i++) zlib.Write(new byte[1 << 20]);
        var file = Png(Header(1, 1, 8, 2), Chunk("IDAT", bomb.ToArray()), Chunk("IEND"));
        Assert.Equal("it holds more data than its pixels need",
            Frugally(() => Assert.Throws<ProblemException>(() => PictureFile.Read(new MemoryStream(file))).Message));
    }

    [Fact]
    public void AGigabyteOfJsonIsRefusedByItsLength()
    {
        var path = Sparse("a.json", 1 << 30);
        Assert.Equal($"{path}: error: the scene file has more than 67,108,864 bytes, which is the limit; put large meshes into mesh files",
            Frugally(() => SceneReader.Read(path).Problems[0].ToString()));
    }

    [Fact]
    public void ASceneOfTheLongestLengthIsNotRefusedForIt() =>
        Assert.Contains("UTF-16", SceneReader.Read(Sparse("a.json", SceneReader.MaxBytes, "{")).Problems[0].Message); // for its zeros, and rightly

    [Fact]
    public void AFileOfNothingButMistakesIsNotReadToItsEnd()
    {
        var text = new StringBuilder("{ \"models\": [");
        for (var i = 0; i < 5000; i++) text.Append("1,");
        var reading = SceneReader.Parse(Encoding.ASCII.GetBytes(text.Append("] }").ToString()), "x", ".");
        Assert.InRange(reading.Problems.Count, 1000, 1010);
        Assert.Matches(@"\nand at least 98\d more\n$", reading.Report());
    }

    [Fact]
    public void WarningsNeverEndTheReading()
    {
        var text = new StringBuilder("{ \"camera\": { \"position\": [5, 0, 0], \"target\": [0, 0, 0] }, \"models\": [");
        for (var i = 0; i < 1500; i++) text.Append("{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1, \"color\": [255, 0, 0] },");
        var reading = SceneReader.Parse(Encoding.ASCII.GetBytes(text.Append("] }").ToString()), "x", ".");
        Assert.Equal((1500, 1000), (reading.Scene!.Models.Count, reading.Problems.Count));
    }

    [Fact(Explicit = true)]
    public void AnEndlessMeshIsReadUpToTheLimit()
    {
        Assert.SkipWhen(!File.Exists("/dev/zero"), "no /dev/zero here");
        File.CreateSymbolicLink(folder["a.obj"], "/dev/zero");
        Assert.Equal($"{folder["a.obj"]}: the pipe or device has more than 268,435,456 bytes, which is the limit; a file may have any size",
            Assert.Throws<ProblemException>(() => MeshFile.Read(folder["a.obj"])).Message);
    }

    [Fact(Explicit = true)]
    public void ALineOfAGigabyteIsRefused()
    {
        var path = folder.Write("a.obj", "v 1 2 ".PadRight(100)); // text at first: a file of zeros is called no text
        using (var file = new FileStream(path, FileMode.Open)) file.SetLength(1 << 30);
        Assert.Equal($"{path}(byte 0): a line or row begins here that has more than 268,435,456 bytes, which is the limit",
            Assert.Throws<ProblemException>(() => MeshFile.Read(path)).Message);
    }

    private string Sparse(string name, long length, string start = "")
    {
        folder.Write(name, start);
        using var file = new FileStream(folder[name], FileMode.Open);
        file.SetLength(length);
        return folder[name];
    }

    private static string RefusedMesh(string name, byte[] file) =>
        Frugally(() => Assert.Throws<ProblemException>(() => MeshBytes.Read(name, file)).Message);

    private static string Frugally(Func<string> message)
    {
        var before = GC.GetAllocatedBytesForCurrentThread();
        var result = message();
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 3 << 20);
        return result;
    }
}
