using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>Whether the schema accepts and refuses what the reader does is tested once a week, by another program
/// (tests/Campaigns/schema.sh).</summary>
public class SceneSchemaTests
{
    private static readonly JsonDocumentOptions lenient = new() { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true };

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
    [MemberData(nameof(Shipped))]
    public void AShippedSceneIsGoodAndNamesTheSchemaForEditors(string scene)
    {
        var file = Path.Combine(SceneFolders.Root, scene);
        var named = JsonNode.Parse(File.ReadAllText(file), null, lenient)!["$schema"]!.GetValue<string>();
        Assert.Equal("", SceneReader.Read(file).Report());
        Assert.Equal(Path.GetFullPath(SceneSchema.File), Path.GetFullPath(Path.Combine(Path.GetDirectoryName(file)!, named)));
    }
}
