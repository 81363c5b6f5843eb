using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Fuzzing;

/// <summary>A sample of spoilt files and odd command lines through the real process: it ends with a picture or with words, and leaves nothing
/// else.</summary>
public sealed class ProcessTests : IDisposable
{
    private const int Sample = 8;
    private readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

    [Fact]
    public void SpoiltFilesEndInAPictureOrInWords()
    {
        foreach (var mesh in Directory.GetFiles(Corpus.SceneFolder, "*.obj")) File.Copy(mesh, raycaster.PathOf(Path.GetFileName(mesh)));
        const string camera = """{ "position": [9, 0, 0], "target": [0, 0, 0], "width": 9, "height": 5 }""";
        raycaster.Write("good.json", $$"""{ "camera": {{camera}}, "models": [{ "type": "sphere", "center": [0, 0, 0], "radius": 2 }] }""");
        for (var i = 0; i < Sample; i++)
        {
            var seeds = (i % 4) switch { 0 or 1 => Corpus.Scenes, 2 => Corpus.Meshes, _ => Corpus.Pictures };
            var input = new Mutation(new Random(Campaign.Seed * 1000 + i), seeds).Next();
            var file = "spoilt" + input.Extension;
            File.WriteAllBytes(raycaster.PathOf(file), input.Bytes);
            raycaster.Write("mesh.json", $$"""{ "camera": {{camera}}, "models": [{ "type": "mesh", "file": "{{file}}" }] }""");
            var before = raycaster.Files;

            raycaster.RunApart("", (i % 4) switch
            {
                0 => [file, "-s", "20x10", "-o", "out.png"],
                1 => ["check", file],
                2 => ["mesh.json", "-o", "out.png"],
                _ => ["diagnose", "good.json", file],
            });

            Assert.Contains(raycaster.ExitCode, (int[])[0, 1, 2]);
            Promise.Wholesome(raycaster.Error);
            Promise.Wholesome(raycaster.OutputText);
            Assert.Equal(raycaster.ExitCode == 0 && i % 2 == 0 ? before.Append("out.png").Order() : before, raycaster.Files);
            File.Delete(raycaster.PathOf("out.png"));
        }
    }

    [Fact]
    public void OddCommandLinesEndInAPictureOrInWords()
    {
        raycaster.Write("scene.json", """{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0], "width": 9, "height": 9 }, "models": [] }""");
        for (var i = 0; i < Sample; i++)
        {
            raycaster.RunApart("", OddCommandLine.Words(OddCommandLine.Next(new Random(Campaign.Seed * 1000 + i))));
            Assert.Contains(raycaster.ExitCode, (int[])[0, 1, 2]);
            Promise.Wholesome(raycaster.Error.Replace("\r", ""));
            Assert.DoesNotContain(raycaster.Files, name => name.EndsWith(".tmp"));
        }
    }
}
