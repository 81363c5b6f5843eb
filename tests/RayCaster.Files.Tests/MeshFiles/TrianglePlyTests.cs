namespace RayCaster.Files.Tests.MeshFiles;

/// <summary>The fast reader of triangle PLYs gives the same result as the general one, or leaves the file to it.</summary>
public class TrianglePlyTests
{
    private static readonly MeshData mesh = new(
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

    [Fact]
    [Trait("kind", "campaign")]
    public void WithAnyByteChangedItIsTheLongWaysAnswerOrNone()
    {
        var (random, right, read) = (new Random(1), MeshWriter.PlyFloat(mesh), 0);
        for (var round = 0; round < 20_000; round++)
        {
            var bytes = right.ToArray();
            for (var change = random.Next(2); change >= 0; change--) bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            MeshData? quick;
            try
            {
                quick = Short(bytes);
            }
            catch (MeshFileException)
            {
                continue; // the header
            }
            if (quick is null) continue;
            read++;
            var thorough = Long(bytes);
            Assert.Equal(Bits(thorough.Vertices), Bits(quick.Vertices));
            Assert.Equal(thorough.Indices, quick.Indices);
        }
        Assert.InRange(read, 2000, 19_000);
    }

    private static MeshData? Short(byte[] bytes, int blockSize = 64, int threads = 1)
    {
        var source = new MeshSource("a.ply", new MemoryStream(bytes), blockSize, threads);
        return TrianglePly.Read(source, new PlyHeader(source));
    }

    private static MeshData Long(byte[] bytes)
    {
        var source = new MeshSource("a.ply", new MemoryStream(bytes));
        var header = new PlyHeader(source);
        return MeshReader.Read(source, () => new PlyFile(source, header));
    }

    private static long[] Bits(Vector3[] vertices) =>
        [.. vertices.SelectMany(v => new[] { v.X, v.Y, v.Z }).Select(BitConverter.DoubleToInt64Bits)];
}
