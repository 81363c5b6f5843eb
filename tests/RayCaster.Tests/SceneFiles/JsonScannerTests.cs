using System.Text;
using System.Text.Json;

namespace RayCaster.Tests.SceneFiles;

/// <summary>What the scanner takes for JSON is what the platform takes for JSON.</summary>
public class JsonScannerTests
{
    private const string Text = """
        {"a": [1, -0.5e-3, 2.25E+7, 0, 1.0], "b\u00e9\n\"\\\/": {"c": true, "d": [false, null, [], {}]}, "e": "é€😀", "f": [[1], [2,],],}
        """;

    private static readonly string[] pieces = ["{", "}", "[", "]", ",", ":", "\"", "\\", "\\u", "0", "1", "-", "+", ".", "e", "true", "nul", "/", " ", "\n", "\t", "\u0001", "é"];

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void ATextIsJsonWhereThePlatformSaysSo(int seed)
    {
        var random = new Random(seed);
        var accepted = 0;
        for (var round = 0; round < 20_000; round++)
        {
            var text = new StringBuilder(Text);
            for (var change = random.Next(3); change >= 0; change--)
            {
                var at = random.Next(text.Length);
                if (random.Next(2) == 0) text.Remove(at, Math.Min(random.Next(1, 4), text.Length - at));
                if (random.Next(2) == 0) text.Insert(Math.Min(at, text.Length), pieces[random.Next(pieces.Length)]);
            }
            var utf8 = Encoding.UTF8.GetBytes(text.ToString());
            var expected = PlatformAccepts(utf8);
            Assert.True(expected == (JsonTree.Parse(new SourceText("a.json", utf8), out var mistake) is not null), $"{text}: {mistake.Message}");
            if (expected) accepted++;
        }
        Assert.InRange(accepted, 1000, 19_000); // both kinds were there
    }

    [Theory]
    [InlineData("/**/{//\n\"a\"/* : */:/**/[1/*,*/,//,\r2/**/]}//", true)]
    [InlineData("{\"a//\": \"/*\"}", true)]
    [InlineData("{} /*", false)]
    [InlineData("{} /", false)]
    [InlineData("{ /* } *", false)]
    [InlineData("[1 /* / * */]", true)]
    [InlineData("//", false)]
    public void CommentsStandWhereBlanksMay(string text, bool isJson) =>
        Assert.Equal(isJson, JsonTree.Parse(new SourceText("a.json", Encoding.UTF8.GetBytes(text)), out _) is not null);

    private static bool PlatformAccepts(byte[] utf8)
    {
        var reader = new Utf8JsonReader(utf8, new JsonReaderOptions { AllowTrailingCommas = true, MaxDepth = JsonTree.MaxDepth });
        try
        {
            while (reader.Read()) { }
            return true;
        }
        catch (JsonException)
        {
            return false;
        }
    }
}
