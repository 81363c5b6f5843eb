using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Files.Tests.Scenes;

public class SceneSchemaTests
{
    private static readonly SchemaValidator Schema = new(SceneSchema.Write());

    public static TheoryData<string> Good => SceneFolders.Scenes("Good");

    /// <summary>The scenes that come with the program.</summary>
    public static TheoryData<string> Shipped
    {
        get
        {
            var scenes = new TheoryData<string>();
            foreach (var file in Directory.GetFiles(Path.Combine(SceneFolders.Root, "scenes"), "*.json", SearchOption.AllDirectories))
                if (file != SceneSchema.File && !ProjectFolder.IsOwnScene(file))
                    scenes.Add(Path.GetRelativePath(SceneFolders.Root, file));
            return scenes;
        }
    }

    /// <summary>Scenes with wrong keys, types, numbers of elements, limits: what a schema can say.</summary>
    public static TheoryData<string> Shape => SceneFolders.Scenes("Broken/Shape");

    /// <summary>Scenes with repeated keys, infinite numbers, values that do not go together, wrong mesh files: what a schema cannot say.</summary>
    public static TheoryData<string> Sense => SceneFolders.Scenes("Broken/Sense");

    /// <summary>Files that are not JSON.</summary>
    public static TheoryData<string> Syntax => SceneFolders.Scenes("Broken/Syntax");

    [Fact]
    public void TheSchemaOfTheScenesSaysWhatTheReaderReads()
    {
        var schema = SceneSchema.Write();
        Assert.True(File.Exists(SceneSchema.File) && File.ReadAllText(SceneSchema.File).ReplaceLineEndings("\n") == schema,
            $"{SceneSchema.File} is not what the reader says; dotnet run --project tests/Documents writes it anew");
    }

    [Theory]
    [MemberData(nameof(Good))]
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

    [Theory]
    [MemberData(nameof(Shape))]
    public void TheSchemaRefusesASceneOfTheWrongShape(string scene) => Assert.False(Schema.Accepts(Text(scene)));

    [Theory]
    [MemberData(nameof(Sense))]
    public void TheSchemaCannotSeeASceneThatMakesNoSense(string scene) => Assert.True(Schema.Accepts(Text(scene)));

    [Theory]
    [MemberData(nameof(Syntax))]
    public void AFileThatIsNotJsonHasNothingForTheSchema(string scene) => Assert.ThrowsAny<JsonException>(() => Schema.Accepts(Text(scene)));

    private static string Text(string scene) => File.ReadAllText(SceneFolders.InTests(scene));
}
