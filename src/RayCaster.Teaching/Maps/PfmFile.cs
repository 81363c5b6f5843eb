using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace RayCaster.Teaching;

/// <summary>
/// PFM, the portable float map. The header has three lines: "Pf" for one number per pixel or "PF" for three; width and height; and a scale,
/// negative for little-endian. Then follow 32-bit floats, the bottom line first.
/// </summary>
public static class PfmFile
{
    /// <summary>The most bytes that are read of a header; usual ones have about twenty.</summary>
    private const int MostOfHeader = 200;

    /// <summary>Writes a map, little-endian (scale −1.0).</summary>
    /// <param name="output">Where the bytes go; stays open.</param>
    public static void Write(Stream output, NumberMap map)
    {
        output.Write(Encoding.ASCII.GetBytes($"{(map.Channels == 1 ? "Pf" : "PF")}\n{map.Width} {map.Height}\n-1.0\n"));
        var numbers = map.Width * map.Channels;
        var line = new byte[4 * numbers];
        for (var y = map.Height - 1; y >= 0; y--)
        {
            for (var i = 0; i < numbers; i++) BinaryPrimitives.WriteSingleLittleEndian(line.AsSpan(4 * i), map.Values[y * numbers + i]);
            output.Write(line);
        }
    }

    /// <summary>Reads a map with either number of channels and either byte order. The size of the scale is ignored.</summary>
    /// <exception cref="PictureFileException">The file is missing, not a PFM, incomplete, or too large.</exception>
    public static NumberMap Read(string path)
    {
        try
        {
            using var file = File.OpenRead(path);
            return Read(file);
        }
        catch (PictureFileException e)
        {
            throw new PictureFileException($"cannot read {path}: {e.Message}", e);
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            throw new PictureFileException($"cannot read {path}: {PictureFileException.Reason(e)}", e);
        }
    }

    /// <summary>Reads a map from a stream whose length is known.</summary>
    /// <inheritdoc cref="Read(string)"/>
    public static NumberMap Read(Stream stream)
    {
        var channels = Word(stream) switch
        {
            "Pf" => 1,
            "PF" => 3,
            var other => throw new PictureFileException($"it begins with '{PrintableText.Of(other)}'; a PFM begins with Pf or PF"),
        };
        var (width, height) = (Side(Word(stream)), Side(Word(stream)));
        var scaleText = Word(stream);
        if (!double.TryParse(scaleText, NumberStyles.Float, CultureInfo.InvariantCulture, out var scale) || scale == 0 || !double.IsFinite(scale))
            throw new PictureFileException($"its scale is '{PrintableText.Of(scaleText)}'; it must be a number other than 0");
        var bytes = (Int128)width * height * channels * 4;
        if (bytes > stream.Length - stream.Position)
            throw new PictureFileException($"{width} × {height} pixels need {bytes:N0} bytes, but only {stream.Length - stream.Position:N0} follow");
        if (bytes / 4 > Array.MaxLength) throw new PictureFileException($"it has {bytes / 4:N0} numbers, the limit is {Array.MaxLength:N0}");

        var map = new NumberMap(width, height, channels);
        var numbers = width * channels;
        var line = new byte[4 * numbers];
        for (var y = height - 1; y >= 0; y--)
        {
            stream.ReadExactly(line);
            for (var i = 0; i < numbers; i++)
                map.Values[y * numbers + i] = scale < 0
                    ? BinaryPrimitives.ReadSingleLittleEndian(line.AsSpan(4 * i))
                    : BinaryPrimitives.ReadSingleBigEndian(line.AsSpan(4 * i));
        }
        return map;
    }

    private static int Side(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var side) && side is > 0 and <= Camera.MaxSide
            ? side
            : throw new PictureFileException($"one side is '{PrintableText.Of(text)}'; it must be a whole number from 1 to {Camera.MaxSide}");

    /// <summary>Reads the next word of the header and one blank after it; the numbers begin after the last blank.</summary>
    private static string Word(Stream stream)
    {
        var word = new StringBuilder();
        while (stream.ReadByte() is >= 0 and var value)
        {
            if (value is not (' ' or '\n' or '\r' or '\t')) word.Append((char)value);
            else if (word.Length > 0) return word.ToString();
            if (stream.Position > MostOfHeader) break;
        }
        throw new PictureFileException("its header is cut");
    }
}
