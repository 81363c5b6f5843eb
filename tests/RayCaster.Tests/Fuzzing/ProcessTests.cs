using RayCaster.Tests.Cli;

namespace RayCaster.Tests.Fuzzing;

/// <summary>A sample of spoilt files and odd command lines through the real process: it ends with a picture or with words, and leaves nothing else.</summary>
public sealed class ProcessTests : IDisposable
{
    private const int Sample = 8;
    private readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

    [Fact]
    public void SpoiltScenesAndMeshes()
    {
        foreach (var mesh in Directory.GetFiles(Corpus.SceneFolder, "*.obj")) File.Copy(mesh, raycaster.PathOf(Path.GetFileName(mesh)));
        for (var i = 0; i < Sample; i++)
        {
            var input = new Mutation(new Random(Campaign.Seed * 1000 + i), i % 2 == 0 ? Corpus.Scenes : Corpus.Meshes).Next();
            var file = "spoilt" + input.Extension;
            File.WriteAllBytes(raycaster.PathOf(file), input.Bytes);
            var scene = $$"""{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0] }, "models": [{ "type": "mesh", "file": "{{file}}" }] }""";
            if (i % 2 == 1) raycaster.Write("mesh.json", scene);
            var before = raycaster.Files;

            raycaster.Run(i % 2 == 0 ? file : "mesh.json", "-s", "20x10", "-o", "out.png");

            Assert.Contains(raycaster.ExitCode, (int[])[0, 2]);
            Reading.Wholesome(raycaster.Error);
            Assert.Equal(raycaster.ExitCode == 0 ? before.Append("out.png").Order() : before, raycaster.Files);
            File.Delete(raycaster.PathOf("out.png"));
        }
    }

    [Fact]
    public void OddCommandLines()
    {
        raycaster.Write("scene.json", """{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0], "width": 9, "height": 9 }, "models": [] }""");
        for (var i = 0; i < Sample; i++)
        {
            raycaster.Run(OddCommandLine.Words(OddCommandLine.Next(new Random(Campaign.Seed * 1000 + i))));
            Assert.Contains(raycaster.ExitCode, (int[])[0, 1, 2]);
            Reading.Wholesome(raycaster.Error.Replace("\r", ""));
            Assert.DoesNotContain(raycaster.Files, name => name.EndsWith(".tmp"));
        }
    }
}
