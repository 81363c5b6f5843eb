using System.Text.Encodings.Web;
using System.Text.Json;

namespace RayCaster.Files;

/// <summary>The form in which this program writes JSON.</summary>
internal static class JsonForm
{
    /// <summary>Indented for people; letters of all languages are not escaped.</summary>
    public static JsonWriterOptions Options => new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };
}
