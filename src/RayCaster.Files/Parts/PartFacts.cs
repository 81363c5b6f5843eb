using System.Globalization;

namespace RayCaster.Files;

/// <summary>
/// Which lines of which picture a file holds. A PNG contains this as a text (chunk tEXt) under <see cref="Keyword"/>; other programs show it and
/// do not change it:
/// <code>
/// picture 500x500
/// lines 0..249
/// scene 7d0e… (64 digits)
/// raycaster 1.0.0
/// </code>
/// </summary>
/// <param name="Digest">The <see cref="SceneDigest"/> of its scene.</param>
public sealed record PartFacts(int Width, int Height, LineRange Lines, string Digest, string Version)
{
    /// <summary>The keyword of the text in the file.</summary>
    public const string Keyword = "raycaster:part";

    private static readonly string[] names = ["picture ", "lines ", "scene ", "raycaster "];

    /// <summary>The version of this library.</summary>
    public static string ThisVersion => typeof(PartFacts).Assembly.GetName().Version!.ToString(3);

    /// <summary>The facts of a part that is drawn now.</summary>
    /// <exception cref="NotSupportedException">A model does not list its <see cref="Model.Numbers"/>.</exception>
    public static PartFacts Of(Scene scene, LineRange lines) =>
        new(scene.Camera.Width, scene.Camera.Height, lines, SceneDigest.Of(scene), ThisVersion);

    /// <summary>Reads what <see cref="ToString"/> writes; null for any other text.</summary>
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
