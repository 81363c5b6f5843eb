namespace RayCaster.Teaching.Diagnosis;

/// <summary>What a search for mistakes tries, and how.</summary>
/// <param name="Known">The known mistakes that are tried.</param>
/// <param name="Done">What the program certainly draws, as <see cref="MissingPart.All"/> calls it.</param>
/// <param name="Likely">Which mistakes are likelier than the others; null for none.</param>
/// <param name="Possible">Which edits are tried that have no name; all if null.</param>
/// <param name="Budget">How much the search may do; null for any amount. The pictures spend it.</param>
/// <param name="Threads">How many threads draw; one per core if null.</param>
internal sealed record SearchOptions(IReadOnlyList<Mistake> Known, IReadOnlyCollection<string> Done, Predicate<Change>? Likely = null,
    Predicate<Change>? Possible = null, SearchBudget? Budget = null, int? Threads = null);
