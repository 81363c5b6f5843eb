namespace RayCaster.Cli.Tests;

/// <summary>Odd names, odd folders and odd inputs: the program answers in a line, with exit code 2, and changes no file.</summary>
public sealed class AttackCampaign : CommandTests
{
    /// <summary>One filter for each mesh and thread would take gigabytes here.</summary>
    [Fact]
    public void AThousandMeshesFitIntoLittleMemory()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "no sh there");
        raycaster.Write("cube.obj",
            "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n" +
            "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        var random = new Random(1);
        var models = string.Join(",\n", Enumerable.Range(0, 1000).Select(_ => FormattableString.Invariant(
            $$"""{ "type": "mesh", "file": "cube.obj", "translate": [{{random.Next(-8, 8)}}, {{random.Next(-8, 8)}}, {{random.Next(-8, 8)}}] }""")));
        raycaster.Write("many.json",
            $$"""{ "camera": { "position": [30, 0, 0], "target": [0, 0, 0], "width": 1000, "height": 1000 }, "models": [ {{models}} ] }""");
        raycaster.RunInShell($"export DOTNET_GCHeapHardLimit={100 << 20:x}; raycaster many.json -t 8 -q");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }
}
