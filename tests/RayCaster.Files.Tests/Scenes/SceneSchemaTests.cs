using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Files.Tests.Scenes;

public class SceneSchemaTests
{
    private static readonly SchemaValidator Schema = new(SceneSchema.Write());

    /// <summary>The scenes that come with the program.</summary>
    public static TheoryData<string> Shipped =>
    [
        .. Directory.GetFiles(Path.Combine(SceneFolders.Root, "scenes"), "*.json", SearchOption.AllDirectories)
            .Where(file => file != SceneSchema.File && !ProjectFolder.IsOwnScene(file))
            .Select(file => Path.GetRelativePath(SceneFolders.Root, file)),
    ];

    [Fact]
    public void TheSchemaOfTheScenesSaysWhatTheReaderReads()
    {
        var schema = SceneSchema.Write();
        Assert.True(File.Exists(SceneSchema.File) && File.ReadAllText(SceneSchema.File).ReplaceLineEndings("\n") == schema,
            $"{SceneSchema.File} is not what the reader says; dotnet run --project tests/Tools/Generator writes it anew");
    }

    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Good", MemberType = typeof(SceneFolders))]
    public void TheSchemaAcceptsWhatTheReaderAccepts(string scene) => Assert.True(Schema.Accepts(Text(scene)));

    [Theory]
    [MemberData(nameof(Shipped))]
    public void AShippedSceneIsGoodAndNamesTheSchemaForEditors(string scene)
    {
        var file = Path.Combine(SceneFolders.Root, scene);
        var text = File.ReadAllText(file);
        var named = JsonNode.Parse(text, null, SchemaValidator.Lenient)!["$schema"]!.GetValue<string>();

        Assert.Equal("", SceneReader.Read(file).Report());
        Assert.True(Schema.Accepts(text));
        Assert.Equal(Path.GetFullPath(SceneSchema.File), Path.GetFullPath(Path.Combine(Path.GetDirectoryName(file)!, named)));
    }

    /// <summary>Wrong keys, types, numbers of elements, limits: what a schema can say.</summary>
    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Shape", MemberType = typeof(SceneFolders))]
    public void TheSchemaRefusesASceneOfTheWrongShape(string scene) => Assert.False(Schema.Accepts(Text(scene)));

    /// <summary>Repeated keys, infinite numbers, values that do not go together, wrong mesh files: what a schema cannot say.</summary>
    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Sense", MemberType = typeof(SceneFolders))]
    public void TheSchemaCannotSeeASceneThatMakesNoSense(string scene) => Assert.True(Schema.Accepts(Text(scene)));

    [Theory]
    [MemberData(nameof(SceneFolders.Scenes), "Broken/Syntax", MemberType = typeof(SceneFolders))]
    public void AFileThatIsNotJsonHasNothingForTheSchema(string scene) => Assert.ThrowsAny<JsonException>(() => Schema.Accepts(Text(scene)));

    private static string Text(string scene) => File.ReadAllText(SceneFolders.InTests(scene));
}
