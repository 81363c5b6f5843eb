namespace RayCaster.Teaching;

/// <summary>What a student gets, and why. It can be kept as JSON and read again.</summary>
/// <param name="Student">The name of the submission's folder.</param>
/// <param name="Digest">Of what it was told: rubric, scenes and submission.</param>
/// <param name="Items">The items of the rubric, in its order.</param>
/// <param name="Scenes">The scenes of the rubric, in its order.</param>
/// <param name="NotDrawn">What the program does not draw yet.</param>
/// <param name="Mistakes">The ids of its mistakes.</param>
/// <param name="LookYourself">What somebody must look at; empty if all is clear.</param>
public sealed record StudentMarks(string Student, string Digest, IReadOnlyList<ItemMarks> Items, IReadOnlyList<SceneMarks> Scenes,
    IReadOnlyList<string> NotDrawn, IReadOnlyList<string> Mistakes, IReadOnlyList<string> LookYourself)
{
    /// <summary>The points that are sure.</summary>
    public double Points => Items.Sum(item => item.Points);

    /// <summary>The points that are neither given nor lost: somebody must look.</summary>
    public double Open => Items.Sum(item => item.Open);
}

/// <summary>What a student gets for an item.</summary>
/// <param name="Name">The item's name.</param>
/// <param name="Of">What it is worth.</param>
/// <param name="Points">The points that are sure.</param>
/// <param name="Open">The points that are neither given nor lost.</param>
/// <param name="Because">The ids of the mistakes and the names of the missing parts that cost it, or that it is in doubt for.</param>
public sealed record ItemMarks(string Name, double Of, double Points, double Open, IReadOnlyList<string> Because);

/// <summary>How the picture of a scene was judged.</summary>
/// <param name="Name">The scene's name.</param>
/// <param name="Verdict">What it came to.</param>
/// <param name="Problem">What is odd about it, in words; null if nothing is.</param>
/// <param name="WrongShare">The share of its pixels that are wrong; 1 where there is none that can be judged.</param>
/// <param name="Small">The picture, made small, as PNG; empty where it is right or not there.</param>
/// <param name="Likeness">The picture, made tiny: pictures that look alike are near each other.</param>
public sealed record SceneMarks(string Name, SceneVerdict Verdict, string? Problem, double WrongShare, byte[] Small, byte[] Likeness);

/// <summary>What the judgement of a picture comes to.</summary>
public enum SceneVerdict
{
    /// <summary>It is right, but for rounding and single pixels on outlines.</summary>
    Right,

    /// <summary>It is wrong, and what is said of the program explains it.</summary>
    Explained,

    /// <summary>It is wrong, and nothing explains it.</summary>
    Unexplained,

    /// <summary>There is no picture, or none of the scene's size.</summary>
    NoPicture,
}
