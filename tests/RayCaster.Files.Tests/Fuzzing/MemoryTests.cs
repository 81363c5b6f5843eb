using System.IO.Compression;
using System.Text;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>The inputs that take the most memory for their size, a megabyte of each; no reader takes more than docs/limits.md says.</summary>
public class MemoryTests
{
    private const int Size = 1 << 20;

    public static TheoryData<string> Scenes => new(
        "{\"models\":[|{},|]}", "{\"models\":[|[],|]}", "{\"models\":[|1,|]}", "{\"models\":[|{\"a\":1},|]}",
        "{\"models\":[|{\"type\":\"mesh\"},|]}",
        "{\"models\":[|{\"type\":\"mesh\",\"file\":\"no.obj\"},|]}", "{\"models\":[|{\"type\":\"sphere\",\"center\":[0,0,0],\"radius\":1},|]}",
        "{\"camera\":{\"position\":[|0,|]}}", "{\"camera\":{|\"fovy\":1,|}}", "{|\"a\\n\":1,|}", "[|[],|]", "|\n|", "|/**/|", "[|//\n|]", "|[|",
        "|/|", "|\"|", "\"|\\n|\"",
        "[|1|]", "{\"camera\":{\"fovY\":|9|}}", "{\"camera\":{\"fovY\":0.|0|1}}", "{\"|\\u0061|\":1}", "|é|", "|\u001b|", "| |");

    [Fact]
    public void ASceneOfAMillionKeysTakesNoMoreThanIsSaid()
    {
        var text = new StringBuilder("{\"camera\":{");
        for (var i = 0; text.Length < Size; i++) text.Append($"\"{i:x}\":1,");
        Reading.OfScene(new("a.json", Encoding.ASCII.GetBytes(text.ToString())));
    }

    public static TheoryData<string, string> Meshes => new()
    {
        { "a.obj", "|v 0 0 0\n|f 1 2 3" },
        { "a.obj", "v 0 0 0\n|f 1 1 1\n|" },
        { "a.obj", "v 0 0 0\n|f 1 1 1\n|f 1 1 9" },
        { "a.obj", "v 0 0 0\nf| 1| 9" },
        { "a.obj", "|v 0 0 0\n|f 1 2 999999999" },
        { "a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\nelement face 1\n" +
            "property list uint char vertex_indices\nend_header\n\0\0\0\0\0\u000f\0|\0|\u0009" },
        { "a.obj", "v 0 0 0\nf| 1|" },
        { "a.obj", "v 0 0 0\nf| -1|" },
        { "a.obj", "v 0 0 |0|\nf 1 1 1" },
        { "a.obj", "|\n|" },
        { "a.obj", "|\\\n|" },
        { "a.obj", "|#|" },
        { "a.obj", "v 1 2 |x|" },
        { "a.stl", "solid\n|facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 0 vertex 0 0 0 endloop endfacet\n|endsolid" },
        { "a.stl", "solid\nfacet normal 0 0 0 outer loop |vertex 0 0 0 |endloop endfacet\nendsolid" },
        { "a.stl", "|solid endsolid\n|" },
        { "a.stl", "solid |facet |" },
        { "a.ply", "ply\nformat ascii 1.0\n|element a 1\n|end_header\n" },
        { "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n|property char a\n|end_header\n" },
        { "a.ply", "ply\n|comment\n|" },
        { "a.ply", "ply\nformat |x|" },
        { "a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 100000\nproperty char x\nproperty char y\nproperty char z\n" +
            "element face 150000\nproperty list uchar char vertex_indices\nend_header\n|\0\0\0\u0003\u0003\0\0\0|" },
        { "a.ply", "ply\nformat ascii 1.0\nelement vertex 100000\nproperty char x\nproperty char y\nproperty char z\nelement face 1\n" +
            "property list uchar char vertex_indices\nend_header\n|0 0 0\n|" },
        { "a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\nelement face 1\n" +
            "property list uint char vertex_indices\nend_header\n\0\0\0\0\0\u000f\0|\0|" },
    };

    public static TheoryData<string> Pictures =>
        new("P2 1000 500 9 |1 |", "P3 1000 170 9 |1 |", "P5 1000 1000 255 |x|", "P6 1|0|",
            "P3 |#\n|", "P2 |9|");

    [Theory]
    [InlineData("IDAT", "IDAT", 0)]
    [InlineData("tEXt", "IDAT", 1)]
    [InlineData("aaAa", "bbBb", 1)]
    public void AMillionChunksTakeNoMoreThanIsSaid(string one, string other, int length)
    {
        var file = new MemoryStream();
        file.Write(PngChunk.Signature);
        PngChunk.Write(file, "IHDR"u8, [0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0]);
        while (file.Length < Size)
            foreach (var type in (string[])[one, other]) PngChunk.Write(file, Encoding.ASCII.GetBytes(type), new byte[length]);
        Reading.OfPicture(new("a.png", file.ToArray()));
    }

    /// <summary>A pipe is read only as far as the header says, even if it never ends, and memory is taken only for the bytes that have
    /// arrived.</summary>
    [Theory]
    [InlineData("P6 5 5 255\n", 5, 5)]
    [InlineData("P5 1000 1000 65535\n", 1000, 1000)]
    [InlineData("P2 100 100 9\n", 100, 100)]
    public void AnEndlessPictureIsReadAsFarAsItsHeaderAsks(string header, int width, int height)
    {
        var pipe = new EndlessPipe(header, header[1] < '4' ? "0 " : "\0");
        Promise.Within(MemoryLimit.OfPipe(0, width, height), () => Assert.Equal(height, PictureFile.Read(pipe).Height));
        Assert.InRange(pipe.Given, 0, header.Length + 2L * width * height + (1 << 17));
    }

    [Fact]
    public void APipeThatPromisesTooMuchTakesNoMoreThanHasCome()
    {
        var bytes = Encoding.ASCII.GetBytes("P6 20000 20000 255\n" + new string('x', 100_000));
        Promise.Within(MemoryLimit.OfPipe(bytes.Length, 0, 0), () =>
            Assert.Contains("but there are 100,000", Assert.Throws<ProblemException>(() => PictureFile.Read(new Pipe(bytes))).Message));
    }

    [Theory(Explicit = true)]
    [MemberData(nameof(Scenes))]
    public void ASceneTakesNoMoreThanIsSaid(string shape) => Reading.OfScene(new("a.json", Filled(shape)));

    [Theory(Explicit = true)]
    [MemberData(nameof(Meshes))]
    public void AMeshTakesNoMoreThanIsSaid(string name, string shape) => Reading.OfMesh(new(name, Filled(shape)));

    [Theory(Explicit = true)]
    [MemberData(nameof(Pictures))]
    public void APictureTakesNoMoreThanIsSaid(string shape) => Reading.OfPicture(new("a.ppm", Filled(shape)));

    /// <summary>What is small in the file and large in memory: lines as long as they may be, in all kinds of pixels, and pictures of one bit a
    /// pixel.</summary>
    [Theory(Explicit = true)]
    [InlineData(1_000_000, 1, 16, 6, false)]
    [InlineData(1_000_000, 1, 8, 2, false)]
    [InlineData(1_000_000, 1, 1, 0, false)]
    [InlineData(1_000_000, 8, 16, 6, true)]
    [InlineData(1_000_000, 8, 1, 3, true)]
    [InlineData(1, 1_000_000, 8, 2, false)]
    [InlineData(8000, 8000, 1, 0, false)]
    public void ASmallFileOfALargePictureTakesNoMoreThanIsSaid(int width, int height, byte bits, byte color, bool interlaced)
    {
        var header = new PngHeader(width, height, bits, color, interlaced);
        var (file, data) = (new MemoryStream(), new MemoryStream());
        using (var zlib = new ZLibStream(data, CompressionLevel.Optimal, leaveOpen: true)) zlib.Write(new byte[(long)header.DataBytes]);
        file.Write(PngChunk.Signature);
        file.Write(RayCaster.Files.Tests.Pictures.TestPng.Header(width, height, bits, color, (byte)(interlaced ? 1 : 0)));
        if (color == PngHeader.Palette) PngChunk.Write(file, "PLTE"u8, [0, 0, 0]);
        PngChunk.Write(file, "IDAT"u8, data.ToArray());
        PngChunk.Write(file, "IEND"u8, []);
        Promise.Within(MemoryLimit.OfPicture(file.Length, width, height), () => PictureFile.Read(new MemoryStream(file.ToArray())));
    }

    /// <summary>The part between two bars is repeated until there is a megabyte.</summary>
    private static byte[] Filled(string shape)
    {
        var parts = Array.ConvertAll(shape.Split('|'), Encoding.UTF8.GetBytes);
        var text = new MemoryStream();
        text.Write(parts[0]);
        while (text.Length < Size) text.Write(parts[1]);
        text.Write(parts[2]);
        return text.ToArray();
    }
}
