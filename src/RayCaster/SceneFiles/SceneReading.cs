using System.Text;

namespace RayCaster;

/// <summary>What came of reading a scene file.</summary>
/// <param name="Scene">The scene, or null if there is an error.</param>
/// <param name="Problems">The errors and warnings, in the order of the file: all of them, or the first thousand that were found.</param>
/// <param name="Unlisted">How many more there are.</param>
public sealed record SceneReading(Scene? Scene, IReadOnlyList<Problem> Problems, int Unlisted = 0)
{
    /// <summary>How many problems <see cref="Report"/> writes out.</summary>
    public const int Printed = 20;

    /// <summary>The problems as text for people, the errors first; empty if there are none. Of many only the first are written out.</summary>
    public string Report()
    {
        var text = new StringBuilder();
        var left = Printed;
        foreach (var errors in (ReadOnlySpan<bool>)[true, false])
            foreach (var problem in Problems)
                if (problem.IsError == errors && left-- > 0)
                    text.Append(problem).Append('\n');
        var more = Unlisted + Math.Max(0, -left);
        if (more > 0) text.Append($"and {more} more\n");
        return text.ToString();
    }
}
