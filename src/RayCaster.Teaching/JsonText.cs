using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayCaster.Teaching;

/// <summary>Objects as JSON text, for other programs and for people to read.</summary>
internal static class JsonText
{
    private static readonly JsonSerializerOptions options = new()
    {
        WriteIndented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping, // letters of all languages stay
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
        NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals,
        Converters = { new JsonStringEnumConverter(JsonNamingPolicy.CamelCase) },
    };

    /// <summary>A property that is written as null; one that is null is left out.</summary>
    public static object Null { get; } = JsonSerializer.SerializeToElement<object?>(null);

    /// <summary>The text, indented, with a line end. NaN and the infinities, which JSON has no numbers for, become texts.</summary>
    public static string Of(object value) => JsonSerializer.Serialize(value, options) + "\n";
}
