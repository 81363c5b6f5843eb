using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Writes the schema of rubrics from the descriptions that the reader gives of its keys, like the schema of scenes.</summary>
internal static class RubricSchema
{
    public static string File { get; } = ProjectFolder.PathOf("docs/rubric.schema.json");

    private static readonly JsonSerializerOptions style =
        new() { WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public static string Write()
    {
        var rubric = SceneObject.Describing(out var keys);
        RubricReader.ReadRubric(rubric, "", new());
        var item = SceneObject.Describing(out var itemKeys);
        RubricReader.ReadItem(item, []);
        var schema = new JsonObject
        {
            ["$schema"] = "http://json-schema.org/draft-07/schema#",
            ["title"] = "Rubric",
            ["description"] = "What a class is marked by: scenes, how a submission draws them, and what costs points.",
            ["allowComments"] = true, // these two are for Visual Studio Code
            ["allowTrailingCommas"] = true,
        };
        foreach (var (name, value) in ObjectOf(keys, ObjectOf(itemKeys, null)).ToArray()) schema[name] = value!.DeepClone();
        return schema.ToJsonString(style) + "\n";
    }

    private static JsonObject ObjectOf(IEnumerable<SceneKey> keys, JsonObject? item) => new()
    {
        ["type"] = "object",
        ["properties"] = new JsonObject(keys.Select(key => KeyValuePair.Create<string, JsonNode?>(key.Name, ValueOf(key, item)))),
        ["required"] = new JsonArray([.. keys.Where(key => key.IsRequired).Select(key => (JsonNode)key.Name)]),
        ["additionalProperties"] = false,
    };

    private static JsonObject ValueOf(SceneKey key, JsonObject? item)
    {
        var schema = key.Kind switch
        {
            KeyKind.Number => NumberOf(key.Limits, "number"),
            KeyKind.Whole => NumberOf(key.Limits, "integer"),
            KeyKind.Flag => new JsonObject { ["type"] = "boolean" },
            KeyKind.Text or KeyKind.FileName => new JsonObject { ["type"] = "string" },
            KeyKind.Texts => new JsonObject { ["type"] = "array", ["items"] = TextOf(key.Name) },
            KeyKind.Choice => new JsonObject { ["enum"] = new JsonArray([.. key.Choices.Select(word => (JsonNode)word)]) },
            KeyKind.Objects => new JsonObject { ["type"] = "array", ["items"] = item!.DeepClone() },
            _ => throw new InvalidOperationException($"no schema for {key.Kind}"),
        };
        schema.Insert(0, "description", key.Meaning);
        if (key.Default is double or int && double.IsFinite(Convert.ToDouble(key.Default))) schema["default"] = Convert.ToDouble(key.Default);
        if (key.Default is string text) schema["default"] = text;
        return schema;
    }

    /// <summary>What is one of known words, so that an editor completes it.</summary>
    private static JsonObject TextOf(string key)
    {
        string[]? words = key switch
        {
            "mistakes" => [.. MistakeCatalog.All.Select(mistake => mistake.Id)],
            "undone" => [.. Diagnosis.Parts],
            _ => null,
        };
        return words is null ? new() { ["type"] = "string" } : new() { ["enum"] = new JsonArray([.. words.Select(word => (JsonNode)word)]) };
    }

    private static JsonObject NumberOf(Limits limits, string type)
    {
        var schema = new JsonObject { ["type"] = type };
        if (double.IsFinite(limits.Least)) schema[limits.IsOpen ? "exclusiveMinimum" : "minimum"] = limits.Least;
        if (double.IsFinite(limits.Most)) schema[limits.IsOpen ? "exclusiveMaximum" : "maximum"] = limits.Most;
        return schema;
    }
}
