using System.Buffers;
using System.Collections;
using System.Diagnostics.CodeAnalysis;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>Objects as JSON text, for other programs and for people to read.</summary>
/// <remarks>JsonSerializer writes objects of anonymous types by code that it makes while it runs, which a native program cannot.</remarks>
internal static class JsonText
{
    private static readonly JsonWriterOptions options = new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping, // letters of all languages stay
    };

    /// <summary>
    /// The text, indented, with a line end. Names of properties begin with a small letter; a property that is null is left out. NaN and the
    /// infinities, which JSON has no numbers for, become texts.
    /// </summary>
    public static string Of(object value)
    {
        var text = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(text, options)) Write(json, value);
        return Encoding.UTF8.GetString(text.WrittenSpan) + "\n";
    }

    [UnconditionalSuppressMessage("Trimming", "IL2075", Justification = "A native program keeps all members of this assembly's types.")]
    private static void Write(Utf8JsonWriter json, object value)
    {
        switch (value)
        {
            case bool flag:
                json.WriteBooleanValue(flag);
                break;
            case double number when double.IsFinite(number):
                json.WriteNumberValue(number);
                break;
            case int or long:
                json.WriteNumberValue(Convert.ToInt64(value, CultureInfo.InvariantCulture));
                break;
            case string or double:
                json.WriteStringValue(Convert.ToString(value, CultureInfo.InvariantCulture));
                break;
            case IEnumerable list:
                json.WriteStartArray();
                foreach (var item in list) Write(json, item);
                json.WriteEndArray();
                break;
            default:
                json.WriteStartObject();
                foreach (var property in value.GetType().GetProperties())
                {
                    if (property.GetValue(value) is not { } content) continue;
                    json.WritePropertyName(JsonNamingPolicy.CamelCase.ConvertName(property.Name));
                    Write(json, content);
                }
                json.WriteEndObject();
                break;
        }
    }
}
