using System.Security.Cryptography;

namespace RayCaster.Teaching;

/// <summary>How a class is marked (docs/teaching.md): the scenes, how to get a submission's pictures, and what costs points.</summary>
public sealed class Rubric
{
    /// <param name="digest">A hash of the rubric's text, the scenes' texts and their right pictures.</param>
    internal Rubric(IReadOnlyList<MarkedScene> scenes, string digest)
    {
        (Scenes, Digest) = (scenes, digest);
        var judges = scenes.Select(scene => scene.Judge).ToArray();
        Known = judges.Any(judge => judge.TooManyModels) ? []
            : [.. MistakeCatalog.All.Intersect(judges.SelectMany(judge => judge.Known)).Except(judges.SelectMany(judge => judge.NotTried))];
    }

    /// <summary>The name of the lab, for the titles of pages.</summary>
    public required string Title { get; init; }

    /// <summary>The hints on the students' pages; null for none. The answer is never shown.</summary>
    public required HintLevel? Hint { get; init; }

    /// <summary>The rubric's file, as a full path.</summary>
    public required string Path { get; init; }

    /// <summary>The parts that have points, in the order of the table.</summary>
    public required IReadOnlyList<RubricItem> Items { get; init; }

    /// <summary>How to get the pictures.</summary>
    public required PictureSource Source { get; init; }

    /// <summary>Whether programs draw variations of the scenes.</summary>
    public bool Vary { get; init; }

    /// <summary>The folder of the built step tests; null if they are not run.</summary>
    public string? Tests { get; init; }

    /// <summary>The sum of all items' points.</summary>
    public double Points => Items.Sum(item => item.Points);

    /// <summary>A hash of all that submissions are judged by: finished marks are kept as long as it is the same.</summary>
    internal string Digest { get; }

    internal IReadOnlyList<MarkedScene> Scenes { get; }

    internal IReadOnlyList<Mistake> Known { get; }

    /// <summary>The rubric with a variation of each scene.</summary>
    /// <param name="seed">The same seed makes the same scenes; students must not know it.</param>
    /// <param name="notice">Called with what is wrong with a scene that stays as it is.</param>
    internal Rubric WithVariedScenes(string seed, Action<string>? notice)
    {
        var varied = Scenes.AsParallel().AsOrdered().Select(scene => scene.Varied(seed, mayShowLess: false)).ToArray();
        for (var i = 0; i < varied.Length; i++)
        {
            if (varied[i] is not null) continue;
            varied[i] = Scenes[i].Varied(seed, mayShowLess: true) ?? Scenes[i];
            notice?.Invoke($"{Scenes[i].Name}: no variation of it that was tried shows all its mistakes, so " +
                (varied[i] == Scenes[i] ? "it is drawn as it is" : "one that shows less is drawn"));
        }
        return new(varied!, $"{Digest}{seed}")
        {
            Title = Title,
            Path = Path,
            Hint = Hint,
            Items = Items,
            Source = Source,
            Tests = Tests,
        };
    }

    /// <summary>A hash of the files that the rubric was read from, as they are now.</summary>
    internal string HashOfFiles() => Convert.ToHexStringLower(SHA256.HashData(
        [.. Scenes.Select(scene => scene.Path).Prepend(Path).SelectMany(path => RegularFile.Read(path, SceneReader.MaxBytes) ?? [])]));

    /// <summary>The item whose points a mistake costs; null if it costs none.</summary>
    internal RubricItem? ItemOf(string mistake) => Items.FirstOrDefault(item => item.Mistakes.Contains(mistake));

    /// <summary>The same for a mistake in a certain variant: one that changes only the formulas of another item's shapes costs that item.</summary>
    internal RubricItem? ItemOf(Mistake variant)
    {
        var item = ItemOf(variant.Id);
        if (item is null || ShapesOf(item) == 0) return item;
        var changed = new Lab(Scenes[0].Scene, variant).ChangedShapes;
        return (ShapesOf(item) & changed) != 0 ? item : Items.FirstOrDefault(other => (ShapesOf(other) & changed) != 0) ?? item;
    }

    private static Affects ShapesOf(RubricItem item) => item.Undone.Aggregate((Affects)0, (shapes, part) => shapes | Mistake.KindOf(part));
}

/// <summary>A part of the lab that has points.</summary>
/// <param name="Each">The points that one of its mistakes costs; all together cost at most the item's points.</param>
/// <param name="Undone">The parts of a program that cost all its points if they are missing (<see cref="Diagnosis.Parts"/>).</param>
public sealed record RubricItem(string Name, double Points, double Each, IReadOnlyList<string> Mistakes, IReadOnlyList<string> Undone)
{
    /// <summary>What the students' pages say of it, whatever was found; null for nothing.</summary>
    public string? Remark { get; init; }

    /// <summary>What decides its points.</summary>
    public ItemEvidence Evidence { get; init; }

    /// <summary>The step whose tests decide, from 1; 0 if the pictures alone do.</summary>
    public int Step { get; init; }
}

/// <summary>How to get a submission's pictures: they are in its folder, or its program draws them.</summary>
/// <param name="Pictures">The path of a picture in the submission's folder; <c>{name}</c> stands for the scene's name.</param>
/// <param name="Build">The command that builds a submission; empty for none.</param>
/// <param name="Run">The command that draws a picture; empty if the pictures are in the folder.</param>
public sealed record PictureSource(string Pictures, IReadOnlyList<string> Build, IReadOnlyList<string> Run, ProgramLimits Limits);

/// <summary>The limits of a student's program.</summary>
/// <param name="OutputBytes">The bytes that it may print, and the size of a file that it may write.</param>
/// <param name="MemoryBytes">The memory of all its processes together.</param>
/// <param name="Network">Whether it may use the network; some systems cannot forbid it.</param>
public sealed record ProgramLimits(TimeSpan Time, TimeSpan BuildTime, long OutputBytes, long MemoryBytes, int Processes, bool Network)
{
    /// <summary>The names of further variables of the teacher's environment that it gets.</summary>
    public IReadOnlyList<string> Environment { get; init; } = [];

    /// <summary>Further files and folders that it may read, as full paths, where others are hidden from it.</summary>
    public IReadOnlyList<string> Readable { get; init; } = [];
}
