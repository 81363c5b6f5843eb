using System.Text.Unicode;

namespace RayCaster.Files;

/// <summary>Knows how programs spoil the bytes of a PGM or PPM so that there are more of them, or fewer, than its header promises.</summary>
/// <param name="endsWithCr">Whether CR ends the header.</param>
internal readonly struct PnmSurplus(int kind, int width, int height, int maxval, bool endsWithCr)
{
    /// <summary>The likely cause; null if it is not known.</summary>
    /// <param name="isHarmless">Whether the pixels are right all the same, or wrong only in a way that a diagnosis names.</param>
    public string? Cause(ReadOnlySpan<byte> data, long due, out bool isHarmless)
    {
        isHarmless = false;
        if (kind < 4)
        {
            var hasBytes = data.ContainsAnyInRange((byte)0, (byte)8) || data.ContainsAnyInRange((byte)14, (byte)31)
                || data.ContainsAnyInRange((byte)127, (byte)255);
            return hasBytes ? $"bytes follow the header, and P{kind} announces a text; the header for bytes is P{kind + 3}" : null;
        }
        if (!data.ContainsAnyExcept("0123456789 \t\r\n"u8) && data.ContainsAny(" \t\r\n"u8) && data.ContainsAnyInRange((byte)'0', (byte)'9'))
            return $"the pixels are a text, and P{kind} announces bytes; the header for a text is P{kind - 3}";
        if (data.Length < due)
            return maxval > 255 && 2 * data.Length == due ? $"maxval is {maxval}, and above 255 a value takes two bytes: write 255"
                : kind == 6 && 3 * data.Length == due ? "it has one byte a pixel; the header for grey is P5"
                : null;

        const string TextMode = "each byte 0A has become two, 0D 0A; open the file in binary mode (\"wb\", ios::binary)";
        var isHeaderSplit = endsWithCr && data is [(byte)'\n', ..];
        var body = isHeaderSplit ? data[1..] : data;
        var splits = body.Count("\r\n"u8);
        if (splits > 0 && splits == body.Count((byte)'\n') && body.Length - splits == due) return TextMode;
        if (isHeaderSplit && body.Length == due)
        {
            isHarmless = true;
            return "the header ends with 0D 0A, of which only 0D belongs to it; end it with \"\\n\", and open the file in binary mode";
        }

        var rest = data[(int)due..];
        isHarmless = rest is [(byte)'P', >= (byte)'1' and <= (byte)'6', ..] || (rest.Length <= 2 && rest.IndexOfAnyExcept(" \t\r\n"u8) < 0);
        if (isHarmless) return null; // another picture, or a line end
        var letters = Utf8.IsValid(body) ? Encoding.UTF8.GetCharCount(body) : body.Length;
        if (letters < body.Length && (letters == due || letters - splits == due))
            return "each byte above 127 has become two or more: write bytes to a stream, not characters or a redirected text";
        if (maxval > 255) return null;
        var pixels = (long)width * height;
        var sample = kind == 6 ? 3 : 1;
        var perPixel = data.Length % pixels == 0 ? data.Length / pixels : 0;
        return (kind, perPixel) switch
        {
            (5, 3) => "P5 is grey, one byte a pixel; the header for colours is P6",
            (6, 4) => "it has four bytes a pixel; a pixel of P6 has red, green and blue, no alpha",
            (_, > 0) => $"it has {perPixel} bytes a pixel; a pixel of P{kind} has {sample}",
            _ when data.Length == (sample * width + 3) / 4 * 4 * (long)height =>
                "each line is filled up to a multiple of 4 bytes; a line of PPM is not",
            _ when data.Length == sample * (width + 1L) * height =>
                "as many as one column more takes: does the loop over columns run once too often?",
            _ when data.Length == sample * (width + 1L) * (height + 1) =>
                "as many as one line and one column more take: do the loops run once too often?",
            _ => null,
        };
    }
}
