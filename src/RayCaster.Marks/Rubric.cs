namespace RayCaster.Marks;

/// <summary>How a class is marked (docs/teaching.md): the scenes, where a student's pictures are, and what costs points.</summary>
public sealed class Rubric
{
    internal Rubric(IReadOnlyList<MarkedScene> scenes)
    {
        Scenes = scenes;
        var judges = scenes.Select(scene => scene.Diagnoser).ToArray();
        Known = judges.Any(judge => judge.TooManyModels) ? []
            : [.. MistakeCatalog.All.Intersect(judges.SelectMany(judge => judge.Known))
                .Where(mistake => judges.All(judge => MutationCoverage.CanTry(judge.Scene, mistake)))];
    }

    internal string Title { get; init; } = "Marks";

    /// <summary>The hints on the students' pages; null for none. The answer is never shown.</summary>
    internal HintLevel? Hint { get; init; }

    /// <summary>The parts that have points, in the order of the table.</summary>
    internal IReadOnlyList<RubricItem> Items { get; init; } = [];

    /// <summary>The path of a picture in a student's folder; <c>{name}</c> stands for the scene's name.</summary>
    internal string Pictures { get; init; } = "{name}.png";

    /// <summary>The JUnit or TRX files in a student's folder, with <c>*</c> and <c>?</c> for any characters; null if tests do not count.</summary>
    internal string? Tests { get; init; }

    internal double Points => Items.Sum(item => item.Points);

    internal IReadOnlyList<MarkedScene> Scenes { get; }

    internal IReadOnlyList<Mistake> Known { get; }

    /// <summary>The item whose points a mistake costs; null if it costs none.</summary>
    internal RubricItem? ItemOf(string mistake) => Items.FirstOrDefault(item => item.Mistakes.Contains(mistake));

    /// <summary>The same for a mistake made in a certain way: one that changes only the formulas of another item's shapes costs that item.</summary>
    internal RubricItem? ItemOf(Change change)
    {
        var item = ItemOf(change.Id);
        if (item is null || !item.MissingParts.Any(MissingPart.IsShape)) return item;
        string[] changed = [.. change.ChangedShapes];
        return IsOfChanged(item) ? item : Items.FirstOrDefault(IsOfChanged) ?? item;

        bool IsOfChanged(RubricItem other) => other.MissingParts.Any(changed.Contains);
    }
}
