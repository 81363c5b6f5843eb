using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Testing;

/// <summary>Schemas (JSON Schema draft-07, which editors know best) of the descriptions that readers give of their keys.</summary>
internal static class KeySchema
{
    private static readonly JsonSerializerOptions Style = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    /// <summary>The text of a schema.</summary>
    public static string Document(string title, string description, JsonObject content)
    {
        var schema = new JsonObject
        {
            ["$schema"] = "http://json-schema.org/draft-07/schema#",
            ["title"] = title,
            ["description"] = description,
            ["allowComments"] = true, // these two are for Visual Studio Code
            ["allowTrailingCommas"] = true,
        };
        foreach (var (name, value) in content) schema[name] = value!.DeepClone();
        return schema.ToJsonString(Style) + "\n";
    }

    /// <param name="element">What the elements of an array of texts or objects are.</param>
    public static JsonObject ObjectOf(IEnumerable<KeySpec> keys, Func<KeySpec, JsonObject> element) => new()
    {
        ["type"] = "object",
        ["properties"] = new JsonObject(keys.Select(key => KeyValuePair.Create<string, JsonNode?>(key.Name, ValueOf(key, element)))),
        ["required"] = ArrayOf(keys.Where(key => key.IsRequired).Select(key => (JsonNode)key.Name)),
        ["additionalProperties"] = false,
    };

    private static JsonObject ValueOf(KeySpec key, Func<KeySpec, JsonObject> element)
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
            KeyKind.Object => ObjectOf(key.Members, element),
            KeyKind.Objects or KeyKind.Texts => new JsonObject { ["type"] = "array", ["items"] = element(key) },
            _ => throw new InvalidOperationException($"no schema for {key.Kind}"),
        };
        var limits = key.Limits == Limits.None ? "" : $" {char.ToUpperInvariant(key.Limits.Words[0])}{key.Limits.Words[1..]}.";
        var value = key.Default is double number && !double.IsFinite(number) ? null : key.Default;
        var orElse = value is not null ? $" Default: {InWords(value)}." : "";
        schema.Insert(0, "description", key.Meaning + limits + orElse);
        if (value is not null) schema["default"] = ToJson(value);
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

    public static JsonObject With(JsonObject schema, string keyword, JsonNode value)
    {
        schema[keyword] = value;
        return schema;
    }

    public static JsonArray ArrayOf(IEnumerable<JsonNode> nodes) => new([.. nodes]);

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
