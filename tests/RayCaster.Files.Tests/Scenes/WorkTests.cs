using System.Text;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>The work to refuse a scene grows in proportion to its bytes: the keys that are compared are counted, and a file of twice the length
/// needs at most about twice as many.</summary>
public sealed class WorkTests : InTemporaryFolder
{
    [Theory]
    [InlineData("{{\"camera\":{{{0}}}}}", "\"{0}\":1,")]                                  // one object of nothing but unknown keys
    [InlineData("{{\"models\":[{{\"type\":\"sphere\",{0}}}]}}", "\"{0}\":1,")]
    [InlineData("{{\"models\":[{0}]}}", "{{\"type\":\"sphere\",\"radius{0}\":1}},")]     // many objects with one
    [InlineData("{{\"models\":[{0}]}}", "{{\"a{0}\":1,\"a{0}\":2}},")]                  // a key twice
    [InlineData("{{{0}}}", "\"models\":\"{0}\",")]
    public void TwiceTheErrorsAreTwiceTheWork(string file, string part)
    {
        var (once, twice) = (KeysLookedAt(file, part, 2000), KeysLookedAt(file, part, 4000));
        Assert.InRange(once, 1, 20 * 2000);
        Assert.InRange(twice, once, 2 * once + 1000);
    }

    [Fact]
    public void OnlyTheMissingFilesThatArePrintedAreComparedWithThoseOfAFolder()
    {
        folder.Write("a1.obj", "x"u8);
        var names = new MissingFileHint();
        Assert.All(Enumerable.Range(0, SceneReading.Printed), _ => Assert.Contains("a1.obj", names.Hint(folder["a2.obj"])));
        Assert.DoesNotContain("a1.obj", names.Hint(folder["a2.obj"]));
    }

    [Fact]
    public void AMeshIsReadOnceInHoweverManyWaysItIsNamed()
    {
        folder.Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"u8);
        var models = string.Concat(
            Enumerable.Range(0, 100).Select(i => $$"""{"type":"mesh","file":"{{string.Concat(Enumerable.Repeat("./", i))}}a.obj"},"""));
        var text = $$"""{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0] }, "models": [{{models}}] }""";
        var reading = SceneReader.Parse(Encoding.ASCII.GetBytes(text), "a.json", folder.Path);
        Assert.Equal(100, reading.Scene!.Models.Count);
        Assert.Equal([folder["a.obj"]], reading.MeshFiles);
    }

    private static long KeysLookedAt(string file, string part, int parts)
    {
        var text = string.Format(null, file, string.Concat(Enumerable.Range(0, parts).Select(i => string.Format(null, part, $"{i:x}"))));
        var tree = JsonTree.Parse(new("a.json", Encoding.ASCII.GetBytes(text), "."))!;
        SceneReader.ReadScene(JsonKeys.AsObject(tree.Root)!);
        Assert.NotEqual(0, tree.Reading.ErrorCount);
        return tree.KeysLookedAt;
    }
}
