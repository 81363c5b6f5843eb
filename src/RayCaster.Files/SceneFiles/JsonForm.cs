using System.Text.Encodings.Web;
using System.Text.Json;

namespace RayCaster.Files;

/// <summary>How JSON is written: for tools, and yet for people to read.</summary>
internal static class JsonForm
{
    /// <summary>Indented, with the letters of every language as they are.</summary>
    public static JsonWriterOptions Options => new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };
}
