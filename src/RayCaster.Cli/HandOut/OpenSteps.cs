using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>Adapts the texts of a hand-out to the steps that its students write: README.md says which ones, CI tests no other.</summary>
internal static partial class OpenSteps
{
    public static bool Concern(string path) => path is "README.md" or ".github/workflows/classroom.yml" or ".gitlab-ci.yml";

    /// <param name="open">The open steps; where none is, CI tests all.</param>
    public static string In(string text, int[] open)
    {
        int[] tested = open.Length > 0 ? open : [.. Enumerable.Range(1, LabSteps.Count)];
        if (tested.Length < LabSteps.Count)
        {
            text = Heading().Replace(text, step => open.Contains(int.Parse(step.Groups["step"].Value)) ? step.Value : $"{step} (done already)");
            var steps = (open.Length == 1 ? "step " : "the steps ") + string.Join(", ", open);
            text = HowToWork().Replace(text, $"**You write {steps}.** The others are written already, and so marked below. Those of their tests " +
                "that draw what you write fail until then. If later steps are written already, your program draws what they add, too: " +
                "the pictures below of your steps lack it.\n\n$0");
        }
        return OfEachStep().Replace(text, part => string.Concat(tested.Select(step => Of(step, part.Value))))
            .Replace("{runners}", string.Join(',', tested.Select(step => $"step{step}")))
            .Replace("{steps}", string.Join(", ", tested));

        static string Of(int step, string part) => part.Replace("{step}", $"{step}").Replace("{name}", Slides.Steps[step - 1].Name);
    }

    [GeneratedRegex(@"^## Step (?<step>\d+): .*\S", RegexOptions.Multiline)]
    private static partial Regex Heading();

    [GeneratedRegex("^## How to work", RegexOptions.Multiline)]
    private static partial Regex HowToWork();

    /// <summary>Of the classroom's workflow, what a step runs, up to an empty line, and where its result goes; of README.md, its points.</summary>
    [GeneratedRegex(@"^ +- id: step\{step\}\n(?:.+\n)+\n|^ +STEP\{step\}_RESULTS: .*\n|^\| \{step\} .*\n", RegexOptions.Multiline)]
    private static partial Regex OfEachStep();
}
