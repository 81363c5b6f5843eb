using System.Text.Json.Nodes;
using static RayCaster.Testing.KeySchema;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Writes the schema of rubrics from the descriptions that the reader gives of its keys, like the schema of scenes.</summary>
internal static class RubricSchema
{
    public static string File { get; } = ProjectFolder.PathOf("docs/rubric.schema.json");

    public static string Write()
    {
        var rubric = JsonKeys.Describing(out var keys);
        RubricReader.ReadRubric(rubric, "", new());
        var item = JsonKeys.Describing(out var itemKeys);
        RubricReader.ReadItem(item, []);
        return Document("Rubric", "What a class is marked by: scenes, where the pictures of them are, and what costs points.",
            ObjectOf(keys, key => key.Kind == KeyKind.Objects ? ObjectOf(itemKeys, TextOf) : TextOf(key)));
    }

    /// <summary>What is one of known words, so that an editor completes it.</summary>
    private static JsonObject TextOf(KeySpec key)
    {
        IEnumerable<string>? words = key.Name switch
        {
            "mistakes" => MistakeCatalog.All.Select(mistake => mistake.Id),
            "undone" => MissingPart.All,
            _ => null,
        };
        return words is null ? new() { ["type"] = "string" } : new() { ["enum"] = ArrayOf(words.Select(word => (JsonNode)word)) };
    }
}
