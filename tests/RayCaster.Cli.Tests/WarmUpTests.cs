using System.Text;

namespace RayCaster.Cli.Tests;

public class WarmUpTests
{
    [Theory]
    [InlineData("plane")]
    [InlineData("sphere")]
    [InlineData("aabb")]
    [InlineData("circle")]
    [InlineData("triangle")]
    [InlineData("mesh")]
    public void AModelIsGuessedFromItsType(string type) => Assert.Equal(type, Assert.Single(Guess($$"""{ "type": "{{type}}" }""", 1)).Kind);

    [Fact]
    public void NothingIsGuessedFromOtherWords() => Assert.Empty(Guess("""{ "name": "spheres" } // a plane and a "mesh """, 100));

    [Fact]
    public void TheBeginningOfAFileIsASceneOfItsFirstModels()
    {
        const string text = """
            { "camera": { "position": [0, 0, 0], "target": [1, 0, 0] }, "models": [
              { "type": "sphere", "center": [1, 0, 0], "radius": 1 },
              { "type": "sphere", "center": [2, 0, 0], "radius": 1 }, { "type": "sph
            """;

        var scene = SceneReader.Parse(WarmUp.Beginning(Encoding.UTF8.GetBytes(text)), "a.json", "").Scene;

        Assert.Equal(2, scene!.Models.Count);
    }

    [Fact]
    public void NoMeshIsReadInAdvance() => Assert.Empty(WarmUp.Beginning("""{ "models": [{ "type": "mesh", "file": "a.ply" }, """u8));

    [Theory]
    [InlineData(1, true)]
    [InlineData(1, false)]
    [InlineData(100, false)]
    public void WhatIsGuessedCanBeDrawn(int count, bool isPlain)
    {
        var models = Guess("\"plane\" \"sphere\" \"aabb\" \"circle\" \"triangle\"" + (isPlain ? "" : " \"mesh\""), count);

        Assert.Null(Record.Exception(() => WarmUp.Draw(models, isPlain)));
    }

    private static List<Model> Guess(string text, int count) => WarmUp.Guess(Encoding.UTF8.GetBytes(text), count);
}
