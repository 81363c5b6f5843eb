namespace RayCaster.Marks;

/// <summary>A student's points, with reasons.</summary>
/// <param name="Typical">The mistakes whose symptoms the pictures certainly show: other variants of a mistake may show others.</param>
/// <param name="HidingMistakes">The mistakes that draw the same pictures as a program in which <paramref name="MissingParts"/> is missing.</param>
/// <param name="LookYourself">What the teacher must look at; empty if nothing is.</param>
internal sealed record StudentMarks(string Student, IReadOnlyList<ItemMarks> Items, IReadOnlyList<SceneMarks> Scenes,
    IReadOnlyList<string> MissingParts, IReadOnlyList<string> Mistakes, IReadOnlyList<string> Typical, IReadOnlyList<string> HidingMistakes,
    IReadOnlyList<string> LookYourself)
{
    /// <summary>What the student must know of the tests, too.</summary>
    public IReadOnlyList<string> OnTests { get; init; } = [];

    /// <summary>The points that the teacher has given, which win over the computed ones; null if the teacher has given none.</summary>
    public double? TeacherPoints { get; init; }

    /// <summary>The teacher's comment, for the student; empty for none.</summary>
    public string Comment { get; init; } = "";

    /// <summary>The teacher's points, or those that are certain.</summary>
    public double Points => TeacherPoints ?? Items.Sum(item => item.Points);

    public double Undecided => TeacherPoints is null ? Items.Sum(item => item.Undecided) : 0;

    public int RightPictures => Scenes.Count(scene => scene.Verdict == SceneVerdict.Right);
}

/// <summary>A student's points for an item.</summary>
/// <param name="Points">The points that are certain.</param>
/// <param name="Undecided">The points that are not decided.</param>
/// <param name="Because">The ids of the mistakes and the names of the missing parts that cost points, or may cost points.</param>
internal sealed record ItemMarks(string Name, double Of, double Points, double Undecided, IReadOnlyList<string> Because)
{
    /// <summary>What the tests of its step say, for example "9 of 12 tests of step 7 pass"; null if they do not count.</summary>
    public string? Tests { get; init; }
}

/// <summary>The judgement of one picture.</summary>
internal sealed record SceneMarks(string Name, SceneVerdict Verdict)
{
    /// <summary>A hash of a wrong picture, the same for two students only if every byte is; null where equal pictures prove nothing.</summary>
    public string? Digest { get; init; }
}

internal enum SceneVerdict
{
    Right, // but for rounding and single pixels on outlines
    Explained, // wrong, and the mistakes that were found explain it
    Unexplained, // wrong, and nothing explains it
    NoPicture, // or one of another size than the scene
}
