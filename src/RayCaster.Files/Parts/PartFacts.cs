using System.Globalization;

namespace RayCaster.Files;

/// <summary>
/// Which lines of which picture a file holds. A PNG carries this as a text (a chunk tEXt) under <see cref="Keyword"/>, which other programs show
/// and leave alone:
/// <code>
/// picture 500x500
/// lines 0..249
/// scene 7d0e… (64 digits)
/// raycaster 1.0.0
/// </code>
/// </summary>
/// <param name="Width">Pixels in a line.</param>
/// <param name="Height">Lines of the whole picture.</param>
/// <param name="Lines">The lines that the file holds.</param>
/// <param name="Digest">What the picture depends on, <see cref="SceneDigest"/>.</param>
/// <param name="Version">The program that has drawn it.</param>
public sealed record PartFacts(int Width, int Height, LineRange Lines, string Digest, string Version)
{
    /// <summary>What the text is called in the file.</summary>
    public const string Keyword = "raycaster:part";

    private static readonly string[] names = ["picture ", "lines ", "scene ", "raycaster "];

    /// <summary>The version of this library.</summary>
    public static string ThisVersion => typeof(PartFacts).Assembly.GetName().Version!.ToString(3);

    /// <summary>What a part drawn now is to say.</summary>
    /// <exception cref="NotSupportedException">A model does not say what it is made of.</exception>
    public static PartFacts Of(Scene scene, LineRange lines) =>
        new(scene.Camera.Width, scene.Camera.Height, lines, SceneDigest.Of(scene), ThisVersion);

    /// <summary>Reads the text; null where it is not as <see cref="ToString"/> writes it.</summary>
    public static PartFacts? Parse(string text)
    {
        var values = text.TrimEnd('\n').Split('\n');
        if (values.Length != names.Length) return null;
        for (var i = 0; i < names.Length; i++)
        {
            if (!values[i].StartsWith(names[i], StringComparison.Ordinal)) return null;
            values[i] = values[i][names[i].Length..];
        }
        if (values[0].Split('x') is not [var w, var h] || Side(w) is not { } width || Side(h) is not { } height) return null;
        return LineRange.Parse(values[1]) is { } lines && lines.Last < height && values[2].Length > 0 && values[3].Length > 0
            ? new(width, height, lines, values[2], values[3])
            : null;
    }

    /// <summary>The text.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture,
        $"{names[0]}{Width}x{Height}\n{names[1]}{Lines}\n{names[2]}{Digest}\n{names[3]}{Version}\n");

    private static int? Side(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var side) && side is >= 1 and <= Camera.MaxSide ? side : null;
}
