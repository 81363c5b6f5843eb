namespace RayCaster.Marks;

/// <summary>A part of the lab that has points.</summary>
/// <param name="Each">The points that one of its mistakes costs; all together cost at most the item's points.</param>
/// <param name="MissingParts">The parts of a program that cost all its points if they are missing (<see cref="MissingPart.All"/>).</param>
internal sealed record RubricItem(string Name, double Points, double Each, IReadOnlyList<string> Mistakes, IReadOnlyList<string> MissingParts)
{
    /// <summary>What the students' pages say of it, whatever was found; null for nothing.</summary>
    public string? Remark { get; init; }

    public ItemEvidence Evidence { get; init; }

    /// <summary>The step whose tests decide, from 1; 0 if the pictures alone do.</summary>
    public int Step { get; init; }
}

/// <summary>What an item's points depend on.</summary>
internal enum ItemEvidence
{
    Pictures,
    Tests,
    Both, // the tests decide what the pictures leave undecided; where the two contradict each other, nothing is decided
}
