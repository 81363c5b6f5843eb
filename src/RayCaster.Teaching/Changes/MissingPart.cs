namespace RayCaster.Teaching.Changes;

/// <summary>What an unfinished program may not do yet: kinds of shape by their names in scene files, attenuation, clipping.</summary>
public static class MissingPart
{
    /// <summary>Models do not get darker with the distance.</summary>
    public const string Attenuation = "attenuation";

    /// <summary>zNear and zFar have no effect; only what lies behind the camera is left out.</summary>
    public const string Clipping = "clipping";

    /// <summary>The kinds of shape as a scene file calls them, then the rest.</summary>
    public static IReadOnlyList<string> All { get; } = [.. ShapeKind.All.Select(kind => kind.Name), Attenuation, Clipping];

    /// <summary>Whether a part is a kind of shape.</summary>
    public static bool IsShape(string part) => part is not (Attenuation or Clipping);

    /// <summary>The lab's step in which a part is written.</summary>
    public static int StepOf(string part) =>
        Slides.StepOf(ShapeKind.Find(part)?.Slide ?? (part == Attenuation ? Slides.Shading : Slides.ClipPlanes));

    /// <summary>A program without a part, as a change of the slides' program.</summary>
    public static Change Without(string part) => ChangeSource.Missing(part);

    /// <summary>Several shapes of a kind, in words.</summary>
    public static string Many(string kind) => ShapeKind.Find(kind)?.Many ?? $"shapes of the type {kind}";

    /// <summary>The mistakes that draw the same as a program without these parts: for example, "no attenuation" is also in the catalogue.</summary>
    internal static IEnumerable<Change> AsMistakes(IEnumerable<string> parts) =>
        All.Where(parts.Contains).SelectMany(MistakeCatalog.DrawnWithout).Select(mistake => mistake.Usual);
}
