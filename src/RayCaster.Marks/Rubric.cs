namespace RayCaster.Marks;

/// <summary>How a class is marked (docs/teaching.md): the scenes, where a student's pictures are, and what costs points.</summary>
public sealed class Rubric
{
    internal Rubric(IReadOnlyList<MarkedScene> scenes)
    {
        Scenes = scenes;
        var judges = scenes.Select(scene => scene.Judge).ToArray();
        Known = judges.Any(judge => judge.TooManyModels) ? []
            : [.. MistakeCatalog.All.Intersect(judges.SelectMany(judge => judge.Known)).Except(judges.SelectMany(judge => judge.NotTried))];
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

    /// <summary>The same for a mistake in a certain variant: one that changes only the formulas of another item's shapes costs that item.</summary>
    internal RubricItem? ItemOf(Mistake variant)
    {
        var item = ItemOf(variant.Id);
        if (item is null || ShapesOf(item) == 0) return item;
        var changed = variant.In(FormulaProgram.For(Scenes[0].Scene.Camera))?.ChangedShapes ?? 0;
        return (ShapesOf(item) & changed) != 0 ? item : Items.FirstOrDefault(other => (ShapesOf(other) & changed) != 0) ?? item;
    }

    private static Affects ShapesOf(RubricItem item) => item.Undone.Aggregate((Affects)0, (shapes, part) => shapes | Mistake.KindOf(part));
}
