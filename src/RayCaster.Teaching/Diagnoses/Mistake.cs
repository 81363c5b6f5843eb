namespace RayCaster.Teaching;

/// <summary>What a mistake touches, so that a scene without it need not be tried.</summary>
[Flags]
public enum Concerns
{
    /// <summary>The way from a pixel to its ray: every picture.</summary>
    Camera = 1,

    /// <summary>Which crossing counts and which of two hits shows: every picture.</summary>
    Hit = 2,

    /// <summary>The formula of planes.</summary>
    Planes = 4,

    /// <summary>The formula of spheres.</summary>
    Spheres = 8,

    /// <summary>The formula of boxes.</summary>
    Boxes = 16,

    /// <summary>The formula of circles.</summary>
    Circles = 32,

    /// <summary>The formula of triangles, those of meshes included.</summary>
    Triangles = 64,

    /// <summary>The way from a hit to three bytes: every picture.</summary>
    Color = 128,

    /// <summary>The way from the bytes to the file: every picture.</summary>
    File = 256,
}

/// <summary>Help in three steps, so that it need not do the homework.</summary>
/// <param name="Symptom">What is to be seen.</param>
/// <param name="Question">What to ask oneself.</param>
/// <param name="Answer">What to write instead.</param>
public sealed record Hint(string Symptom, string Question, string Answer);

/// <summary>
/// Something that people get wrong in a ray caster, stated as a small deviation from the definition: it changes one or two steps of a
/// <see cref="Lab"/>, and what it does not change is right. Several may be made at once.
/// </summary>
public sealed class Mistake
{
    private readonly List<Mistake> wordings = [];
    private readonly List<(string Cause, Action<Lab> Deviate)> manners = [];

    /// <summary>States a mistake, and its hint.</summary>
    internal Mistake(string id, Concerns concerns, string slide, string cause, Action<Lab> deviate,
        string symptom, string question, string answer, bool isWithinRounding = false)
        : this(id, concerns, slide, cause, deviate, new Hint(symptom, question, answer)) => IsWithinRounding = isWithinRounding;

    private Mistake(string id, Concerns concerns, string slide, string cause, Action<Lab> deviate, Hint hint)
    {
        (Id, Concerns, Slide, Cause, Deviate, Hint) = (id, concerns, slide, cause, deviate, hint);
        wordings.Add(this);
    }

    /// <summary>A short name without blanks, the same for ever.</summary>
    public string Id { get; }

    /// <summary>What is wrong in the program, in one line.</summary>
    public string Cause { get; }

    /// <summary>The title of the slide that has the right formula; docs/slides-to-code.md leads from it to the code.</summary>
    public string Slide { get; }

    /// <summary>Help in three steps.</summary>
    public Hint Hint { get; }

    /// <summary>What it touches.</summary>
    public Concerns Concerns { get; }

    /// <summary>The same mistake as different people write it: one id, but each a cause of its own. This one is the first.</summary>
    public IReadOnlyList<Mistake> Wordings => wordings;

    /// <summary>Plants the mistake.</summary>
    internal Action<Lab> Deviate { get; }

    /// <summary>Whether it moves no channel by more than a level, as rounding does, so that no wrong pixel can be its work.</summary>
    internal bool IsWithinRounding { get; }

    /// <summary>Whether a scene has what the mistake touches; where not, its picture is right.</summary>
    public bool Touches(Scene scene) => TouchesAny(scene.Models.Select(KindOf));

    /// <summary>Whether a program has what the mistake touches that draws these kinds of shape, as a scene file calls them.</summary>
    public bool Touches(IEnumerable<string> kinds) => TouchesAny(kinds.Select(KindOf));

    private bool TouchesAny(IEnumerable<Concerns> shapes)
    {
        const Concerns always = Concerns.Camera | Concerns.Hit | Concerns.Color | Concerns.File;
        return shapes.Any(shape => (Concerns & shape) != 0) || (Concerns & always) != 0;
    }

    /// <summary>Its id.</summary>
    public override string ToString() => Id;

    /// <summary>Adds a wording: another place where the same thought goes wrong.</summary>
    internal Mistake Or(string cause, Action<Lab> deviate)
    {
        wordings.Add(new Mistake(Id, Concerns, Slide, cause, deviate, Hint));
        return this;
    }

    /// <summary>Adds a family of wordings.</summary>
    internal Mistake Or(IEnumerable<(string Cause, Action<Lab> Deviate)> family)
    {
        foreach (var (cause, deviate) in family) Or(cause, deviate);
        return this;
    }

    /// <summary>Adds manners: formulas that are right, but in which the mistake shows otherwise.</summary>
    internal Mistake In(params ReadOnlySpan<(string Cause, Action<Lab> Deviate)> more)
    {
        manners.AddRange(more);
        return this;
    }

    /// <summary>A wording of this mistake in each of its manners.</summary>
    internal IEnumerable<Mistake> InManners(Mistake wording) =>
        manners.Select(manner => new Mistake(Id, Concerns, Slide, $"{wording.Cause}; {manner.Cause}", wording.Deviate + manner.Deviate, Hint));

    /// <summary>The formula that a model is drawn by.</summary>
    internal static Concerns KindOf(Model model) => KindOf(model.Kind);

    /// <summary>The formula that a kind of shape, as a scene file calls it, is drawn by.</summary>
    internal static Concerns KindOf(string kind) => kind switch
    {
        "plane" => Concerns.Planes,
        "sphere" => Concerns.Spheres,
        "aabb" => Concerns.Boxes,
        "circle" => Concerns.Circles,
        "triangle" or "mesh" => Concerns.Triangles,
        _ => 0,
    };
}
