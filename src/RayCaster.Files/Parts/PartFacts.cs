using System.Reflection;
using System.Security.Cryptography;
using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>
/// Which lines of which picture a file holds. A PNG contains this as a text (chunk tEXt) under "raycaster:part"; other programs show it and do
/// not change it:
/// <code>
/// picture 500x500
/// lines 0..249
/// scene 7d0e… (64 digits)
/// raycaster 1.1.0+5f0c…
/// </code>
/// </summary>
/// <param name="Digest">The <see cref="SceneDigest"/> of its scene.</param>
/// <param name="Version">The version of the program, and 12 digits that change with its code.</param>
internal sealed partial record PartFacts(int Width, int Height, NumberRange Lines, string Digest, string Version)
{
    internal const string Keyword = "raycaster:part";

    /// <param name="models">The digest of the scene's models (<see cref="SceneDigest.OfModels"/>).</param>
    public static PartFacts Create(Scene scene, NumberRange lines, string models, Assembly engine) =>
        new(scene.Camera.Width, scene.Camera.Height, lines, SceneDigest.Compute(scene, models),
            VersionOf(typeof(Scene).Assembly, typeof(PartFacts).Assembly, engine));

    /// <summary>The version of a program and a hash of its code: an edited formula draws other parts.</summary>
    internal static string VersionOf(params IEnumerable<Assembly> assemblies)
    {
        var code = SHA256.HashData([.. assemblies.SelectMany(assembly => assembly.ManifestModule.ModuleVersionId.ToByteArray())]);
        return $"{typeof(PartFacts).Assembly.GetName().Version!.ToString(3)}+{Convert.ToHexStringLower(code)[..12]}";
    }

    public static PartFacts? Parse(string text)
    {
        var values = Form().Match(text).Groups;
        return Side(values[1].ValueSpan) is { } width && Side(values[2].ValueSpan) is { } height
            && NumberRange.Parse(values[3].Value) is { } lines && lines.Last < height
            ? new(width, height, lines, values[4].Value, values[5].Value)
            : null;
    }

    public (string Keyword, string Value) PngText => (Keyword, ToString());

    public override string ToString() => string.Create(CultureInfo.InvariantCulture,
        $"picture {Width}x{Height}\nlines {Lines}\nscene {Digest}\nraycaster {Version}\n");

    [GeneratedRegex(@"^picture ([^x\n]*)x(.*)\nlines (.*)\nscene (.+)\nraycaster (.+)\n*$")]
    private static partial Regex Form();

    private static int? Side(ReadOnlySpan<char> text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var side) && side is >= 1 and <= Camera.MaxSide ? side : null;
}
