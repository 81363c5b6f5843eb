namespace RayCaster.Files.Tests.SceneFiles;

public class SceneReaderCampaign
{
    /// <summary>Cuts and spoils good scenes at every byte: a scene or an error, never an exception.</summary>
    [Theory]
    [MemberData(nameof(BrokenSceneTests.Good), MemberType = typeof(BrokenSceneTests))]
    public void NoSpoiltByteMakesTheReaderThrow(string scene)
    {
        var folder = SceneFolders.InTests("Good");
        var text = File.ReadAllBytes(SceneFolders.InTests(scene));
        for (var i = 0; i < text.Length; i++)
        {
            Check(text[..i]);
            foreach (var spoilt in "\"\\{}[],:/*-.e0'\n\t\0\u0080"u8)
            {
                var copy = text.ToArray();
                copy[i] = spoilt;
                Check(copy);
            }
        }

        void Check(byte[] utf8)
        {
            var reading = SceneReader.Parse(utf8, "x", folder);
            Assert.Equal(reading.Scene is null, reading.Problems.Any(problem => problem.IsError));
            Assert.All(reading.Problems, problem => Assert.True(problem is { Line: > 0, Column: > 0 }));
        }
    }
}
