using System.Text.Json;
using System.Text.Json.Serialization;

namespace RayCaster.Teaching;

/// <summary>A student's points, with reasons. Can be written and read as JSON.</summary>
/// <param name="Digest">A hash of the rubric, the scenes, the submission and the student's page.</param>
/// <param name="Typical">The mistakes whose symptoms the pictures certainly show: other variants of a mistake may show others.</param>
/// <param name="Losing">The mistakes that draw the same pictures as a program in which <paramref name="NotDrawn"/> is missing.</param>
/// <param name="LookYourself">What the teacher must look at; empty if nothing is.</param>
public sealed record StudentMarks(string Student, string Digest, IReadOnlyList<ItemMarks> Items, IReadOnlyList<SceneMarks> Scenes,
    IReadOnlyList<string> NotDrawn, IReadOnlyList<string> Mistakes, IReadOnlyList<string> Typical, IReadOnlyList<string> Losing,
    IReadOnlyList<string> LookYourself)
{
    /// <summary>The points that the teacher has given, which win over the computed ones; null if the teacher has given none.</summary>
    public double? TeacherPoints { get; init; }

    /// <summary>The teacher's comment, for the student; null for none.</summary>
    public string? Comment { get; init; }

    /// <summary>The teacher's points, or those that are certain.</summary>
    public double Points => TeacherPoints ?? Items.Sum(item => item.Points);

    /// <summary>The points that are not decided: the teacher must look.</summary>
    public double Undecided => TeacherPoints is null ? Items.Sum(item => item.Undecided) : 0;

    /// <summary>How many scenes have the right picture.</summary>
    public int RightPictures => Scenes.Count(scene => scene.Verdict == SceneVerdict.Right);

    /// <summary>Why no scene has a picture, if the reason is the same for all, such as a program that does not build; otherwise null.</summary>
    public string? CommonProblem =>
        Scenes.All(scene => scene.Verdict == SceneVerdict.NoPicture) && Scenes.Select(scene => scene.Problem).Distinct().Count() == 1
            ? Scenes[0].Problem : null;
}

/// <summary>A student's points for an item.</summary>
/// <param name="Points">The points that are certain.</param>
/// <param name="Undecided">The points that are not decided.</param>
/// <param name="Because">The ids of the mistakes and the names of the missing parts that cost points, or may cost points.</param>
public sealed record ItemMarks(string Name, double Of, double Points, double Undecided, IReadOnlyList<string> Because)
{
    /// <summary>What the tests of its step say, for example "9 of 12 tests of step 7 pass"; null if they do not count.</summary>
    public string? Tests { get; init; }
}

/// <summary>The judgement of one picture.</summary>
/// <param name="Problem">What is unusual about the picture, in words; null if nothing is.</param>
public sealed record SceneMarks(string Name, SceneVerdict Verdict, string? Problem);

/// <summary>The result of judging a picture.</summary>
public enum SceneVerdict
{
    /// <summary>It is right, but for rounding and single pixels on outlines.</summary>
    Right,

    /// <summary>It is wrong, and the mistakes that were found explain it.</summary>
    Explained,

    /// <summary>It is wrong, and nothing explains it.</summary>
    Unexplained,

    /// <summary>There is no picture, or it has another size than the scene.</summary>
    NoPicture,
}

/// <summary>Reads and writes the file of a student's finished marks. A file that lacks a part is an error.</summary>
[JsonSourceGenerationOptions(JsonSerializerDefaults.Web, RespectRequiredConstructorParameters = true)]
[JsonSerializable(typeof(StudentMarks))]
internal sealed partial class KeptMarks : JsonSerializerContext;
