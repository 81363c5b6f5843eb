using System.Text.Json.Nodes;
using static RayCaster.Testing.KeySchema;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>
/// Writes the schema of scene files (JSON Schema draft-07, which editors know best) from the descriptions that the reader gives of its keys.
/// </summary>
internal static class SceneSchema
{
    public static readonly string File = ProjectFolder.PathOf("scenes/scene.schema.json");

    public static string Write()
    {
        var scene = JsonKeys.Describing(out var keys);
        SceneReader.ReadScene(scene);
        var definitions = PrimitiveList.All.Select(type => KeyValuePair.Create<string, JsonNode?>(type.Name, ModelOf(type)));
        return Document("Scene", "A scene for RayCaster: a camera and the models that it sees.",
            With(ObjectOf(keys, Element), "definitions", new JsonObject(definitions.Prepend(new("model", AnyModel())))));
    }

    private static JsonObject Element(KeySpec key) => new() { ["$ref"] = "#/definitions/model" };

    /// <summary>A model of some type: the type says by which definition it is checked, so that an editor complains about this type's keys
    /// only.</summary>
    private static JsonObject AnyModel() => new()
    {
        ["title"] = "Model",
        ["type"] = "object",
        ["properties"] = new JsonObject
        {
            ["type"] = new JsonObject
            {
                ["description"] = "What the model is.",
                ["enum"] = ArrayOf(PrimitiveList.All.Select(type => (JsonNode)type.Name)),
                ["enumDescriptions"] = ArrayOf(PrimitiveList.All.Select(type => (JsonNode)type.Meaning)),
            },
        },
        ["required"] = ArrayOf(["type"]),
        ["allOf"] = ArrayOf(PrimitiveList.All.Select(type => (JsonNode)new JsonObject
        {
            ["if"] = new JsonObject
            {
                ["properties"] = new JsonObject { ["type"] = new JsonObject { ["const"] = type.Name } },
                ["required"] = ArrayOf(["type"])
            },
            ["then"] = new JsonObject { ["$ref"] = $"#/definitions/{type.Name}" },
        })),
    };

    private static JsonObject ModelOf(PrimitiveType type)
    {
        var model = JsonKeys.Describing(out var keys);
        SceneReader.ReadModel(model, type);
        var schema = ObjectOf(keys, Element);
        schema["properties"]!.AsObject().Insert(0, "type", new JsonObject { ["const"] = type.Name, ["description"] = type.Meaning });
        if (keys.Any(key => key.Kind == KeyKind.Faces)) // a file, or what would stand in it
            schema["oneOf"] = ArrayOf([Requiring("file"), Requiring("vertices", "faces")]);
        return schema;
    }

    private static JsonObject Requiring(params string[] keys) => new() { ["required"] = ArrayOf(keys.Select(key => (JsonNode)key)) };
}
