using System.Text;

namespace RayCaster.Files.Tests.MeshFiles;

/// <summary>Bytes after the rows that a PLY's header promises are an error, unless they are blanks.</summary>
public class PlyRestTests
{
    private const string Header =
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    private const string Ascii = "ply\nformat ascii 1.0\n" + Header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

    [Theory]
    [InlineData("")]
    [InlineData("\n\n \r\n")]
    public void BlanksMayFollowTheLastRow(string rest)
    {
        Assert.Equal(3, Read(Encoding.ASCII.GetBytes(Ascii + rest)).Indices.Length);
        Assert.Equal(3, Read([.. Binary(), .. Encoding.ASCII.GetBytes(rest)]).Indices.Length);
    }

    [Fact]
    public void ARowTooManyIsRefused() => Assert.Equal("a.ply(15): there is more in the file than the rows that its header promises",
        Assert.Throws<ProblemException>(() => Read(Encoding.ASCII.GetBytes(Ascii + "\n3 0 1 2\n"))).Message);

    [Fact]
    public void BytesTooManyAreRefused()
    {
        var file = Binary();
        Assert.Equal($"a.ply(byte {file.Length}): there is more in the file than the rows that its header promises",
            Assert.Throws<ProblemException>(() => Read([.. file, 3, 0, 0, 0, 0])).Message);
    }

    private static byte[] Binary()
    {
        var file = new List<byte>(Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\n" + Header));
        foreach (var number in (float[])[0, 0, 0, 1, 0, 0, 0, 1, 0]) file.AddRange(BitConverter.GetBytes(number));
        file.Add(3);
        foreach (var index in (int[])[0, 1, 2]) file.AddRange(BitConverter.GetBytes(index));
        return [.. file];
    }

    private static MeshData Read(byte[] bytes) => MeshBytes.Read("a.ply", bytes);
}
