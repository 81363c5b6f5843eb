namespace RayCaster.Files.Tests.MeshFiles;

/// <summary>The fast reader of triangle PLYs gives the same result as the general one, or leaves the file to it.</summary>
public class TrianglePlyTests
{
    internal static readonly MeshData mesh = new(
        [new(0, 0, 0), new(1, 0, 0.5), new(0, -1.25, 0), new(0, 0, 1e30f), new(3, 4, -5)],
        [0, 1, 2, 0, 2, 3, 4, 3, 0, 1, 2, 4, 4, 4, 4]);

    [Theory]
    [InlineData(1, 1 << 20)]
    [InlineData(1, 13)]
    [InlineData(3, 30)]
    public void TrianglesAreReadWhereverTheFileIsCut(int threads, int blockSize)
    {
        var read = Short(MeshWriter.PlyFloat(mesh), blockSize, threads);
        Assert.NotNull(read);
        Assert.Equal(mesh.Vertices, read.Vertices);
        Assert.Equal(mesh.Indices, read.Indices);
    }

    [Fact]
    public void WhatIsOtherwiseIsLeftToTheLongWay()
    {
        Assert.Null(Short(MeshWriter.PlyBinary(mesh, bigEndian: false))); // doubles
        Assert.Null(Short(MeshWriter.PlyBinary(mesh, bigEndian: true)));
        Assert.Null(Short(MeshWriter.PlyAscii(mesh)));
        Assert.Null(Short(MeshWriter.PlyFloat(mesh)[..^1]));
    }

    internal static MeshData? Short(byte[] bytes, int blockSize = 64, int threads = 1)
    {
        var source = new MeshSource("a.ply", new MemoryStream(bytes), blockSize, threads);
        return TrianglePly.Read(source, new PlyHeader(source));
    }

    internal static MeshData Long(byte[] bytes)
    {
        var source = new MeshSource("a.ply", new MemoryStream(bytes));
        var header = new PlyHeader(source);
        return MeshReader.Read(source, () => new PlyFile(source, header));
    }

    internal static long[] Bits(Vector3[] vertices) =>
        [.. vertices.SelectMany(v => new[] { v.X, v.Y, v.Z }).Select(BitConverter.DoubleToInt64Bits)];
}
