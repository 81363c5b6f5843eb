namespace RayCaster.Teaching;

/// <summary>What a mistake affects: it need not be tried on a scene without that.</summary>
[Flags]
internal enum Affects
{
    Camera = 1, // the way from a pixel to its ray: every picture
    Hit = 2, // which crossing counts and which of two hits shows: every picture
    Planes = 4, // the formula of planes, and so on
    Spheres = 8,
    Boxes = 16,
    Circles = 32,
    Triangles = 64, // those of meshes included
    Color = 128, // the way from a hit to three bytes: every picture
    File = 256, // the way from the bytes to the file: every picture
}

/// <summary>Help in three steps: the first ones leave the work to the student.</summary>
/// <param name="Symptom">What one sees.</param>
/// <param name="Question">What to ask oneself.</param>
/// <param name="Answer">What to write instead.</param>
public sealed record Hint(string Symptom, string Question, string Answer);

/// <summary>
/// A mistake that people make in a ray caster, stated as a small deviation from the definition: it changes one or two steps of a
/// <see cref="Lab"/>, and all other steps stay right. A program may have several.
/// </summary>
public sealed class Mistake
{
    /// <summary>What affects every picture, whatever shapes are in it.</summary>
    internal const Affects WholePicture = Affects.Camera | Affects.Hit | Affects.Color | Affects.File;

    private readonly List<Mistake> variants = [];

    internal Mistake(string id, Affects affects, string slide, string cause, Action<Lab> deviate,
        string symptom, string question, string answer, bool isWithinRounding = false)
        : this(id, affects, slide, cause, deviate, new Hint(symptom, question, answer)) => IsWithinRounding = isWithinRounding;

    private Mistake(string id, Affects affects, string slide, string cause, Action<Lab> deviate, Hint hint)
    {
        (Id, Affects, Slide, Cause, Deviate, Hint) = (id, affects, slide, cause, deviate, hint);
        variants.Add(this);
    }

    /// <summary>A change of the definition that is no mistake.</summary>
    internal static Mistake Unnamed(Action<Lab> deviate) => new("", Affects.Camera, "", "", deviate, "", "", "");

    /// <summary>A short name without blanks, the same for ever.</summary>
    public string Id { get; }

    /// <summary>What is wrong in the program, in one line.</summary>
    public string Cause { get; }

    /// <summary>The title of the slide with the right formula; docs/slides-to-code.md names its code.</summary>
    public string Slide { get; }

    /// <summary>Help in three steps.</summary>
    public Hint Hint { get; }

    internal Affects Affects { get; }

    /// <summary>Where it is, if it is a small edit of the slides' formulas that the catalogue does not have; its id is "edit".</summary>
    public EditPlace? Place { get; internal init; }

    /// <summary>The same mistake as different people write it: one id, but a cause for each. This one is the first.</summary>
    public IReadOnlyList<Mistake> Variants => variants;

    internal Action<Lab> Deviate { get; }

    /// <summary>Whether it changes channels by at most a level, like rounding, so it makes no pixel wrong.</summary>
    internal bool IsWithinRounding { get; }

    /// <summary>Whether a scene has what the mistake affects; if not, its picture is right.</summary>
    public bool Touches(Scene scene) => Touches(scene.Models.Select(model => model.Kind));

    /// <summary>Whether the mistake affects programs that draw these kinds of shape, by their names in scene files.</summary>
    public bool Touches(IEnumerable<string> kinds) => (Affects & WholePicture) != 0 || kinds.Any(kind => (Affects & KindOf(kind)) != 0);

    /// <summary>Its id.</summary>
    public override string ToString() => Id;

    /// <summary>Adds a variant: another place where the same mistake is made.</summary>
    internal Mistake Or(string cause, Action<Lab> deviate)
    {
        variants.Add(Worded(cause, deviate));
        return this;
    }

    /// <summary>The same mistake with another cause and another change of the lab.</summary>
    internal Mistake Worded(string cause, Action<Lab> deviate) => new(Id, Affects, Slide, cause, deviate, Hint);

    internal Mistake Or(IEnumerable<(string Cause, Action<Lab> Deviate)> family)
    {
        foreach (var (cause, deviate) in family) Or(cause, deviate);
        return this;
    }

    internal static Affects KindOf(Model model) => KindOf(model.Kind);

    /// <summary>The formula of a kind of shape, by its name in scene files.</summary>
    internal static Affects KindOf(string kind) => ShapeKind.Of(kind)?.Formula ?? 0;
}
