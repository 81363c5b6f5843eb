using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Files.Tests.SceneFiles;

/// <summary>
/// Writes the schema of scene files (JSON Schema draft-07, which editors know best) from the descriptions that the reader gives of its keys.
/// </summary>
internal static class SceneSchema
{
    public static readonly string File = Path.Combine(SceneFolders.Root, "scenes/scene.schema.json");

    private static readonly JsonSerializerOptions Style = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    public static string Write()
    {
        var scene = SceneObject.Describing(out var keys);
        SceneReader.ReadScene(scene);
        var schema = new JsonObject
        {
            ["$schema"] = "http://json-schema.org/draft-07/schema#",
            ["title"] = "Scene",
            ["description"] = "A scene for RayCaster: a camera and the models that it sees.",
            ["allowComments"] = true,        // these two are for Visual Studio Code
            ["allowTrailingCommas"] = true,
        };
        foreach (var (name, value) in ObjectOf(keys).ToArray()) schema[name] = value!.DeepClone();
        schema["definitions"] = new JsonObject(
            PrimitiveList.All.Select(type => KeyValuePair.Create<string, JsonNode?>(type.Name, ModelOf(type))).Prepend(new("model", AnyModel())));
        return schema.ToJsonString(Style) + "\n";
    }

    private static JsonObject ObjectOf(IEnumerable<SceneKey> keys) => new()
    {
        ["type"] = "object",
        ["properties"] = new JsonObject(keys.Select(key => KeyValuePair.Create<string, JsonNode?>(key.Name, ValueOf(key)))),
        ["required"] = ArrayOf(keys.Where(key => key.IsRequired).Select(key => (JsonNode)key.Name)),
        ["additionalProperties"] = false,
    };

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
        var model = SceneObject.Describing(out var keys);
        SceneReader.ReadModel(model, type);
        var schema = ObjectOf(keys);
        schema["properties"]!.AsObject().Insert(0, "type", new JsonObject { ["const"] = type.Name, ["description"] = type.Meaning });
        if (keys.Any(key => key.Kind == KeyKind.Faces)) // a file, or what would stand in it
            schema["oneOf"] = ArrayOf([Requiring("file"), Requiring("vertices", "faces")]);
        return schema;
    }

    private static JsonObject Requiring(params string[] keys) => new() { ["required"] = ArrayOf(keys.Select(key => (JsonNode)key)) };

    private static JsonObject ValueOf(SceneKey key)
    {
        var schema = key.Kind switch
        {
            KeyKind.Number => NumberOf(key.Limits, "number"),
            KeyKind.Whole => NumberOf(key.Limits, "integer"),
            KeyKind.Vector => VectorOf(Limits.None),
            KeyKind.Vectors => new JsonObject { ["type"] = "array", ["items"] = VectorOf(Limits.None) },
            KeyKind.Faces => new JsonObject { ["type"] = "array", ["minItems"] = 1, ["items"] = FaceOf() },
            KeyKind.Direction => With(VectorOf(Limits.None), "not", new JsonObject { ["const"] = ArrayOf([0, 0, 0]) }),
            KeyKind.Factors => AnyOf(NumberOf(Limits.NotZero, "number"), VectorOf(Limits.NotZero)),
            KeyKind.Color => AnyOf(VectorOf(Limits.NotNegative), new JsonObject { ["type"] = "string", ["pattern"] = "^#[0-9A-Fa-f]{6}$" }),
            KeyKind.FileName => new JsonObject { ["type"] = "string", ["minLength"] = 1 },
            KeyKind.Text => new JsonObject { ["type"] = "string" },
            KeyKind.Choice => new JsonObject { ["enum"] = ArrayOf(key.Choices.Select(word => (JsonNode)word)) },
            KeyKind.Object => ObjectOf(key.Members),
            KeyKind.Objects => new JsonObject { ["type"] = "array", ["items"] = new JsonObject { ["$ref"] = "#/definitions/model" } },
            _ => throw new InvalidOperationException($"no schema for {key.Kind}"),
        };
        var limits = key.Limits == Limits.None ? "" : $" {char.ToUpperInvariant(key.Limits.Words[0])}{key.Limits.Words[1..]}.";
        var orElse = key.Default is { } value ? $" Default: {InWords(value)}." : "";
        schema.Insert(0, "description", key.Meaning + limits + orElse);
        if (key.Default is not null) schema["default"] = ToJson(key.Default);
        return schema;
    }

    private static JsonObject NumberOf(Limits limits, string type)
    {
        var schema = new JsonObject { ["type"] = type };
        if (double.IsFinite(limits.Least)) schema[limits.IsOpen ? "exclusiveMinimum" : "minimum"] = limits.Least;
        if (double.IsFinite(limits.Most)) schema[limits.IsOpen ? "exclusiveMaximum" : "maximum"] = limits.Most;
        return limits.IsZeroRefused ? With(schema, "not", new JsonObject { ["const"] = 0 }) : schema;
    }

    private static JsonObject VectorOf(Limits limits) => new()
    {
        ["type"] = "array",
        ["items"] = NumberOf(limits, "number"),
        ["minItems"] = 3,
        ["maxItems"] = 3,
    };

    private static JsonObject FaceOf() => new()
    {
        ["type"] = "array",
        ["items"] = NumberOf(Limits.NotNegative, "integer"),
        ["minItems"] = 3,
    };

    private static JsonObject AnyOf(params JsonNode[] schemas) => new() { ["anyOf"] = ArrayOf(schemas) };

    private static JsonObject With(JsonObject schema, string keyword, JsonNode value)
    {
        schema[keyword] = value;
        return schema;
    }

    private static JsonArray ArrayOf(IEnumerable<JsonNode> nodes) => new([.. nodes]);

    private static string InWords(object value) => ToJson(value).ToJsonString(new(Style) { WriteIndented = false }).Replace(",", ", ");

    private static JsonNode ToJson(object value) => value switch
    {
        double number => number,
        int number => number,
        string text => text,
        Vector3 v => ArrayOf([v.X, v.Y, v.Z]),
        Color c => ArrayOf([c.R, c.G, c.B]),
        _ => throw new InvalidOperationException($"no JSON for {value}"),
    };
}
