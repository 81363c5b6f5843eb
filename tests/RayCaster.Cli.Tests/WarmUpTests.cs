using System.Text;

namespace RayCaster.Cli.Tests;

public class WarmUpTests
{
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

    [Fact]
    public void AMeshCanBeDrawnInAdvance() => Assert.Null(Record.Exception(() => WarmUp.Draw(WarmUp.Sheet(), isPlain: false)));
}
