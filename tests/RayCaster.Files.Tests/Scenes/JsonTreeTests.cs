using System.Text;

namespace RayCaster.Files.Tests.Scenes;

public class JsonTreeTests
{
    [Theory]
    [InlineData("/**/{//\n\"a\":/**/[1/*,*/,//,\r2/**/]}//", true)]
    [InlineData("{\"a//\": \"/*\"}", true)]
    [InlineData("// , \"\n/* * / */{/**/\"camera\":// three \" {\n/* \" */ [0]/* // */, \"models\" :/*://*/[/* // */],}// end", true)]
    [InlineData("{ \"a\" /**/ : 1 }", false)]
    [InlineData("{} /*", false)]
    [InlineData("{} /", false)]
    [InlineData("{ /* } *", false)]
    [InlineData("[1 /* / * */]", true)]
    [InlineData("//", false)]
    public void CommentsStandBesideValuesAndBeforeKeys(string text, bool isJson) => Assert.Equal(isJson, Parse(text) is not null);

    [Fact]
    public void TokensKnowTheirPlace()
    {
        const string text = """{ "k\"ey" : /* : */ [1e3, true, { }], "é": "té" }""";
        var root = Parse(text)!.Root;

        Assert.Equal(text, root.AsWritten);
        Assert.Equal(["\"k\\\"ey\"", "[1e3, true, { }]", "\"é\"", "\"té\""], root.Content.Select(value => value.AsWritten));
        Assert.Equal(["1e3", "true", "{ }"], root.Content.ElementAt(1).Content.Select(value => value.AsWritten));
    }

    private static JsonTree? Parse(string text) => JsonTree.Parse(new SourceText("a.json", Encoding.UTF8.GetBytes(text)), out _);
}
