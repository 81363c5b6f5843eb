using System.Text.Json;
using System.Text.RegularExpressions;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>Checks a JSON value against a JSON Schema; knows only the keywords that our schema uses and refuses others.</summary>
/// <remarks>JsonSchema.Net reads numbers as decimals: it takes 1e-200 for 0 and fails on 1e40, and our limits are ±1e100.</remarks>
internal sealed class SchemaValidator(string schema)
{
    public static readonly JsonDocumentOptions Lenient = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };

    private readonly JsonElement root = JsonDocument.Parse(schema).RootElement;

    public bool Accepts(string json) => Accepts(root, JsonDocument.Parse(json, Lenient).RootElement);

    private bool Accepts(JsonElement schema, JsonElement value) => schema.EnumerateObject().All(keyword => Accepts(schema, keyword, value));

    private bool Accepts(JsonElement schema, JsonProperty keyword, JsonElement value)
    {
        var said = keyword.Value;
        return keyword.Name switch
        {
            "$schema" or "title" or "description" or "default" or "definitions" or "enumDescriptions" => true,
            "allowComments" or "allowTrailingCommas" or "then" => true,
            "$ref" => Accepts(root.GetProperty("definitions").GetProperty(said.GetString()!["#/definitions/".Length..]), value),
            "type" => IsOfType(said.GetString()!, value),
            "const" => JsonElement.DeepEquals(said, value) || SameNumbers(said, value),
            "enum" => said.EnumerateArray().Any(choice => JsonElement.DeepEquals(choice, value)),
            "not" => !Accepts(said, value),
            "anyOf" => said.EnumerateArray().Any(one => Accepts(one, value)),
            "oneOf" => said.EnumerateArray().Count(one => Accepts(one, value)) == 1,
            "allOf" => said.EnumerateArray().All(one => Accepts(one, value)),
            "if" => !Accepts(said, value) || Accepts(schema.GetProperty("then"), value),
            "properties" => !IsObject(value) || value.EnumerateObject().All(p => !said.TryGetProperty(p.Name, out var of) || Accepts(of, p.Value)),
            "required" => !IsObject(value) || said.EnumerateArray().All(name => value.TryGetProperty(name.GetString()!, out _)),
            "additionalProperties" => !IsObject(value)
                || value.EnumerateObject().All(p => schema.GetProperty("properties").TryGetProperty(p.Name, out _)),
            "items" => !IsArray(value) || value.EnumerateArray().All(item => Accepts(said, item)),
            "minItems" => !IsArray(value) || value.GetArrayLength() >= said.GetInt32(),
            "maxItems" => !IsArray(value) || value.GetArrayLength() <= said.GetInt32(),
            "minimum" => !IsNumber(value) || value.GetDouble() >= said.GetDouble(),
            "maximum" => !IsNumber(value) || value.GetDouble() <= said.GetDouble(),
            "exclusiveMinimum" => !IsNumber(value) || value.GetDouble() > said.GetDouble(),
            "exclusiveMaximum" => !IsNumber(value) || value.GetDouble() < said.GetDouble(),
            "minLength" => value.ValueKind != JsonValueKind.String || value.GetString()!.Length >= said.GetInt32(),
            "pattern" => value.ValueKind != JsonValueKind.String || Regex.IsMatch(value.GetString()!, said.GetString()!),
            _ => throw new NotSupportedException($"the schema uses {keyword.Name}, which this validator does not know"),
        };
    }

    private static bool IsOfType(string type, JsonElement value) => type switch
    {
        "object" => IsObject(value),
        "array" => IsArray(value),
        "string" => value.ValueKind == JsonValueKind.String,
        "number" => IsNumber(value),
        "integer" => IsNumber(value) && value.GetDouble() == Math.Floor(value.GetDouble()),
        _ => throw new NotSupportedException($"the schema uses the type {type}, which this validator does not know"),
    };

    private static bool SameNumbers(JsonElement a, JsonElement b) => IsNumber(a) && IsNumber(b)
        ? a.GetDouble() == b.GetDouble()
        : IsArray(a) && IsArray(b) && a.GetArrayLength() == b.GetArrayLength()
            && a.EnumerateArray().Zip(b.EnumerateArray()).All(pair => SameNumbers(pair.First, pair.Second));

    private static bool IsObject(JsonElement value) => value.ValueKind == JsonValueKind.Object;

    private static bool IsArray(JsonElement value) => value.ValueKind == JsonValueKind.Array;

    private static bool IsNumber(JsonElement value) => value.ValueKind == JsonValueKind.Number;
}
