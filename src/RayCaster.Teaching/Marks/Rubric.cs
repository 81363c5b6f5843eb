namespace RayCaster.Teaching;

/// <summary>What a class is marked by (docs/teaching.md): scenes, how a submission's pictures come about, and what costs points.</summary>
public sealed class Rubric
{
    /// <param name="scenes">The scenes.</param>
    /// <param name="digest">A number that changes with the text of the rubric and of its scenes.</param>
    internal Rubric(IReadOnlyList<MarkedScene> scenes, string digest)
    {
        (Scenes, Digest) = (scenes, digest);
        var judges = scenes.Select(scene => scene.Judge).ToArray();
        Known = judges.Any(judge => judge.TooManyModels) ? []
            : [.. MistakeCatalog.All.Intersect(judges.SelectMany(judge => judge.Known)).Except(judges.SelectMany(judge => judge.NotTried))];
    }

    /// <summary>What is marked, for the heads of pages.</summary>
    public required string Title { get; init; }

    /// <summary>How much of a hint the students' pages tell; null for none. The answer is never told.</summary>
    public required HintLevel? Hint { get; init; }

    /// <summary>What is marked, in the order of the table.</summary>
    public required IReadOnlyList<RubricItem> Items { get; init; }

    /// <summary>How the pictures come about.</summary>
    public required PictureSource Source { get; init; }

    /// <summary>All points that there are.</summary>
    public double Points => Items.Sum(item => item.Points);

    /// <summary>The text of the rubric and of its scenes, as a number: results are kept as long as it stays.</summary>
    internal string Digest { get; }

    /// <summary>The scenes.</summary>
    internal IReadOnlyList<MarkedScene> Scenes { get; }

    /// <summary>The mistakes to try.</summary>
    internal IReadOnlyList<Mistake> Known { get; }

    /// <summary>The item that a mistake costs points of; null where it costs none.</summary>
    internal RubricItem? ItemOf(string mistake) => Items.FirstOrDefault(item => item.Mistakes.Contains(mistake));
}

/// <summary>A part of the work that has points of its own.</summary>
/// <param name="Name">What it is called.</param>
/// <param name="Points">What it is worth.</param>
/// <param name="Each">What one of its mistakes costs; never more than the item has is lost.</param>
/// <param name="Mistakes">The ids of the mistakes that cost it.</param>
/// <param name="Undone">The parts of a program that cost all its points if they are missing (<see cref="Diagnosis.Parts"/>).</param>
public sealed record RubricItem(string Name, double Points, double Each, IReadOnlyList<string> Mistakes, IReadOnlyList<string> Undone);

/// <summary>How a submission's pictures come about: they lie in its folder, or its program draws them.</summary>
/// <param name="Pictures">The file of a picture in the submission's folder, <c>{name}</c> standing for the scene's name.</param>
/// <param name="Build">A command that is run once for each submission before; empty for none.</param>
/// <param name="Run">The command that draws a picture; empty where the pictures are there already.</param>
/// <param name="Limits">What a command may use.</param>
public sealed record PictureSource(string Pictures, IReadOnlyList<string> Build, IReadOnlyList<string> Run, ProgramLimits Limits);

/// <summary>What a student's program may use.</summary>
/// <param name="Time">How long it may take for a picture.</param>
/// <param name="BuildTime">How long building may take.</param>
/// <param name="OutputBytes">How much it may print, and how large a file it writes may be.</param>
/// <param name="MemoryBytes">How much memory all its processes may hold together.</param>
/// <param name="Processes">How many processes it may be.</param>
/// <param name="Network">Whether it may use the network where that can be forbidden.</param>
public sealed record ProgramLimits(TimeSpan Time, TimeSpan BuildTime, long OutputBytes, long MemoryBytes, int Processes, bool Network);
