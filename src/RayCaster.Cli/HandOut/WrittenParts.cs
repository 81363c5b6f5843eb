using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>What is written in the hand-out that this program lies in: a step is, when none of its bodies calls <c>Todo.Note</c> any more.</summary>
internal static partial class WrittenParts
{
    /// <summary>The parts as "diagnose --done" calls them; none where there is no hand-out.</summary>
    public static string[] Find()
    {
        var lab = new DirectoryInfo(Path.Combine(AppContext.BaseDirectory, "..", "src", "Lab"));
        if (!lab.Exists) return [];
        var open = lab.EnumerateFiles("*.cs").SelectMany(file => Note().Matches(File.ReadAllText(file.FullName)))
            .Select(note => Slides.StepOf(note.Groups["slide"].Value)).ToHashSet();
        return [.. MissingPart.All.Where(part => !open.Contains(MissingPart.StepOf(part)))];
    }

    [GeneratedRegex(@"^\s*(return )?Todo\.Note\(""(?<slide>[^""]+)""", RegexOptions.Multiline)]
    private static partial Regex Note();
}
