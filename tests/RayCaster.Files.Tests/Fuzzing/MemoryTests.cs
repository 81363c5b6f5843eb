using RayCaster.Testing.Fuzzing;
using System.Text;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>The inputs that take the most memory for their size, a megabyte of each; no reader takes more than docs/limits.md says.</summary>
public class MemoryTests
{
    private const int Size = 1 << 20;

    public static TheoryData<string> Scenes => new(
        "{\"models\":[|{},|]}", "{\"models\":[|[],|]}", "{\"models\":[|1,|]}", "{\"models\":[|{\"a\":1},|]}", "{\"models\":[|{\"type\":\"mesh\"},|]}",
        "{\"models\":[|{\"type\":\"mesh\",\"file\":\"no.obj\"},|]}", "{\"models\":[|{\"type\":\"sphere\",\"center\":[0,0,0],\"radius\":1},|]}",
        "{\"camera\":{\"position\":[|0,|]}}", "{\"camera\":{|\"fovy\":1,|}}", "{|\"a\\n\":1,|}", "[|[],|]", "|\n|", "|/**/|", "[|//\n|]", "|[|", "|/|", "|\"|", "\"|\\n|\"",
        "[|1|]", "{\"camera\":{\"fovY\":|9|}}", "{\"camera\":{\"fovY\":0.|0|1}}", "{\"|\\u0061|\":1}", "|é|", "|\u001b|", "| |");

    [Theory]
    [MemberData(nameof(Scenes))]
    public void ASceneTakesNoMoreThanIsSaid(string shape) => Reading.OfScene(new("a.json", Filled(shape)));

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
        { "a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 100000\nproperty char x\nproperty char y\nproperty char z\nelement face 150000\nproperty list uchar char vertex_indices\nend_header\n|\0\0\0\u0003\u0003\0\0\0|" },
        { "a.ply", "ply\nformat ascii 1.0\nelement vertex 100000\nproperty char x\nproperty char y\nproperty char z\nelement face 1\nproperty list uchar char vertex_indices\nend_header\n|0 0 0\n|" },
        { "a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\nelement face 1\nproperty list uint char vertex_indices\nend_header\n\0\0\0\0\0\u000f\0|\0|" },
    };

    [Theory]
    [MemberData(nameof(Meshes))]
    public void AMeshTakesNoMoreThanIsSaid(string name, string shape) => Reading.OfMesh(new(name, Filled(shape)));

    public static TheoryData<string> Pictures => new("P1 1000 1000 |0|", "P1 1 1000000 |1|", "P2 1000 500 9 |1 |", "P3 1000 170 9 |1 |", "P5 1000 1000 255 |x|", "P6 1|0|", "P3 |#\n|", "P2 |9|");

    [Theory]
    [MemberData(nameof(Pictures))]
    public void APictureTakesNoMoreThanIsSaid(string shape) => Reading.OfPicture(new("a.ppm", Filled(shape)));

    [Fact]
    public void AMillionChunksTakeNoMoreThanIsSaid()
    {
        var file = new MemoryStream();
        file.Write(PngChunk.Signature);
        PngChunk.Write(file, "IHDR"u8, [0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0]);
        while (file.Length < Size) PngChunk.Write(file, "IDAT"u8, []);
        Reading.OfPicture(new("a.png", file.ToArray()));
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
