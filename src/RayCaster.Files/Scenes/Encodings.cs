using System.Text.Unicode;

namespace RayCaster.Files;

/// <summary>Recognises files that are not UTF-8.</summary>
internal static class Encodings
{
    public static JsonMistake? MistakeIn(ReadOnlySpan<byte> text)
    {
        if (text is [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..] or [0, not 0, ..] or [not 0, 0, ..] or [0, 0, 0xFE, 0xFF, ..])
            return new(0, 0, "the file is in UTF-16 or UTF-32; save it as UTF-8");
        if (text is [0x89, (byte)'P', (byte)'N', (byte)'G', ..]
            or [(byte)'P', >= (byte)'1' and <= (byte)'6', (byte)'\n' or (byte)'\r' or (byte)' ', ..])
            return new(0, 0, "this is a picture, not a scene; name the scene first, then the picture");
        if (Utf8.IsValid(text)) return null;
        var at = 0;
        while (Rune.DecodeFromUtf8(text[at..], out _, out var length) == System.Buffers.OperationStatus.Done) at += length;
        return new(at, at + 1, $"the byte {text[at]:X2} is not UTF-8; save the file as UTF-8");
    }
}
