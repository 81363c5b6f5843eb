using System.Text.Unicode;

namespace RayCaster.Files;

/// <summary>Recognises files of other kinds by their first bytes, and other encodings, for messages.</summary>
internal static class FileSignature
{
    public const int Bytes = 23;

    private const string Coff = "a compiled object file (COFF), as Visual Studio makes them";

    private static readonly (byte[] Start, string Name)[] kinds =
    [
        ([0xFF, 0xD8, 0xFF], "a JPEG, whose colours are not exact"), ([0x89, .. "PNG"u8], "a PNG"), ([.. "GIF8"u8], "a GIF"),
        ([.. "BM"u8], "a BMP"), ([.. "II*\0"u8], "a TIFF"), ([.. "MM\0*"u8], "a TIFF"), ([.. "8BPS"u8], "a picture of Photoshop (PSD)"),
        ([.. "PF\n"u8], "a picture of floats (PFM)"), ([.. "Pf\n"u8], "a picture of floats (PFM)"), ([.. "P7\n"u8], "a PAM (P7)"),
        ([.. "P1"u8], "a bitmap (PBM), which has no colours"), ([.. "P4"u8], "a bitmap (PBM), which has no colours"),
        ([0x1F, 0x8B], "compressed (gzip); unpack it first"), ([.. "PK"u8, 3, 4], "a zip archive; unpack it first"),
        ([.. "7z"u8, 0xBC, 0xAF], "a 7z archive; unpack it first"), ([.. "Rar!"u8], "a RAR archive; unpack it first"),
        ([.. "%PDF"u8], "a PDF"), ([0x64, 0x86], Coff), ([0x4C, 0x01], Coff), ([.. "ply\n"u8], "a PLY mesh"), ([.. "ply\r"u8], "a PLY mesh"),
        ([.. "solid "u8], "an STL mesh"),
    ];

    /// <summary>What a file is, for the end of "it is …"; null if that is not known.</summary>
    public static string? Recognize(ReadOnlySpan<byte> start)
    {
        if (start.StartsWith("RIFF"u8) && start.Length >= 12 && start[8..12].SequenceEqual("WEBP"u8)) return "a WebP";
        if (start.Length >= 12 && start[4..8].SequenceEqual("ftyp"u8)) return "an HEIC picture or a film";
        foreach (var (begin, name) in kinds)
            if (start.StartsWith(begin)) return name;
        Span<char> letters = stackalloc char[Bytes];
        Utf8.ToUtf16(start[..Math.Min(start.Length, Bytes)], letters, out _, out var count);
        var text = letters[..count].TrimStart("\uFEFF \t\r\n");
        if (text.StartsWith("version https://git-lfs")) return "only a Git LFS pointer to the file (fetch the file itself: git lfs pull)";
        return text.StartsWith("<!doctype html", StringComparison.OrdinalIgnoreCase) || text.StartsWith("<html", StringComparison.OrdinalIgnoreCase)
            ? "a web page (HTML), saved in place of the file" : null;
    }

    public static bool IsUtf16(ReadOnlySpan<byte> start) =>
        start is [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..] or [0, not 0, 0, not 0, ..] or [not 0, 0, not 0, 0, ..];

    /// <summary>The first byte that is not UTF-8, as JSON must be, and why; null if all are.</summary>
    public static (int At, string Message)? NotUtf8(ReadOnlySpan<byte> text)
    {
        if (text is [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..] or [0, not 0, ..] or [not 0, 0, ..] or [0, 0, 0xFE, 0xFF, ..])
            return (0, "the file is in UTF-16 or UTF-32; save it as UTF-8");
        if (text is [0x89, (byte)'P', (byte)'N', (byte)'G', ..]
            or [(byte)'P', >= (byte)'1' and <= (byte)'6', (byte)'\n' or (byte)'\r' or (byte)' ', ..])
            return (0, "this is a picture, not a scene; name the scene first, then the picture");
        if (Utf8.IsValid(text)) return null;
        var at = 0;
        while (Rune.DecodeFromUtf8(text[at..], out _, out var length) == System.Buffers.OperationStatus.Done) at += length;
        return (at, $"the byte {text[at]:X2} is not UTF-8; save the file as UTF-8");
    }
}
