using System.Text.Json;

namespace RayCaster.Tests.SceneFiles;

public class SceneSchemaTests
{
    private static readonly SchemaValidator Schema = new(SceneSchema.Write());

    public static TheoryData<string> Good => SceneFolders.Scenes("Good");

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
        if (Environment.GetEnvironmentVariable("RAYCASTER_ACCEPT") == "1") File.WriteAllText(SceneSchema.File, schema);

        Assert.True(File.Exists(SceneSchema.File) && File.ReadAllText(SceneSchema.File).ReplaceLineEndings("\n") == schema,
            $"{SceneSchema.File} is not what the reader says; RAYCASTER_ACCEPT=1 dotnet test --filter {nameof(SceneSchemaTests)} writes it anew");
    }

    [Theory]
    [MemberData(nameof(Good))]
    public void TheSchemaAcceptsWhatTheReaderAccepts(string scene) => Assert.True(Schema.Accepts(Text(scene)));

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
