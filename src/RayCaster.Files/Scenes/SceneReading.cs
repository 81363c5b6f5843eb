namespace RayCaster.Files;

/// <summary>The result of reading a scene file.</summary>
/// <param name="Problems">The errors and warnings in the order of the file, at most about <see cref="MaxProblems"/>.</param>
public sealed record SceneReading(Scene? Scene, IReadOnlyList<Problem> Problems)
{
    /// <summary>After this many errors the rest of a file is not read, and after this many problems no warning is kept: a large file that is all
    /// mistakes would take hours.</summary>
    public const int MaxProblems = 1000;

    /// <summary>How many problems <see cref="Report"/> writes out.</summary>
    public const int Printed = 20;

    /// <summary>The full paths of the mesh files that the scene names, also of those that could not be read.</summary>
    public IReadOnlyCollection<string> MeshFiles { get; init; } = [];

    /// <summary>The file's bytes, also if they contain mistakes; empty if it cannot be read.</summary>
    public ReadOnlyMemory<byte> Text { get; init; }

    /// <summary>Whether the file cannot be read at all, for example because it is not there.</summary>
    public bool IsUnread => Problems.Any(problem => problem.IsError && problem.Line == 0);

    /// <summary>The first problems as text for people, errors before warnings; empty if there are none.</summary>
    public string Report()
    {
        if (Problems.Count == 0) return "";
        var more = Problems.Count <= Printed ? "" : $"and {(Problems.Count < MaxProblems ? "" : "at least ")}{Problems.Count - Printed} more\n";
        return string.Concat(Problems.OrderByDescending(problem => problem.IsError).Take(Printed).Select(problem => $"{problem}\n")) + more;
    }
}
