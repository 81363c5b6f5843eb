using System.Text;

namespace RayCaster.Files;

/// <summary>What came of reading a scene file.</summary>
/// <param name="Scene">The scene, or null if there is an error.</param>
/// <param name="Problems">The errors and warnings, in the order of the file; a file with a thousand errors is not read to its end.</param>
public sealed record SceneReading(Scene? Scene, IReadOnlyList<Problem> Problems)
{
    /// <summary>After so many errors the rest of a file is not read, and after so many problems no warning is kept: a large file of nothing but
    /// mistakes would take hours.</summary>
    public const int MostProblems = 1000;

    /// <summary>How many problems <see cref="Report"/> writes out.</summary>
    public const int Printed = 20;

    /// <summary>The mesh files that the scene names, by their full paths, whether or not they could be read: what to watch for a change, and not
    /// to overwrite.</summary>
    public IReadOnlyCollection<string> MeshFiles { get; init; } = [];

    /// <summary>The problems as text for people, the errors first; empty if there are none. Of many only the first are written out.</summary>
    public string Report()
    {
        var text = new StringBuilder();
        var left = Printed;
        foreach (var errors in (ReadOnlySpan<bool>)[true, false])
            foreach (var problem in Problems)
                if (problem.IsError == errors && left-- > 0)
                    text.Append(problem).Append('\n');
        if (left < 0) text.Append($"and {(Problems.Count < MostProblems ? "" : "at least ")}{-left} more\n");
        return text.ToString();
    }
}
