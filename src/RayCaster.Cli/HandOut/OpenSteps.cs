using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>Adapts the texts of a hand-out to the steps that its students write: README.md says which ones, CI tests no other.</summary>
internal static partial class OpenSteps
{
    /// <summary>Whether a file depends on the steps that are open.</summary>
    public static bool Concern(string path) => path is "README.md" or ".github/workflows/classroom.yml" or ".gitlab-ci.yml";

    /// <param name="open">The open steps, at least one.</param>
    public static string In(string text, int[] open)
    {
        if (open.Length == LabSteps.Count) return text;
        text = Heading().Replace(text, step => IsOpen(step) ? step.Value : $"{step.Value} (done already)");
        var steps = (open.Length == 1 ? "step " : "the steps ") + string.Join(", ", open);
        text = HowToWork().Replace(text, $"**You write {steps}.** The others are written already, and so marked below. Those of their tests that " +
            "draw what you write fail until then.\n\n$0");
        text = PartOfWorkflow().Replace(text, step => IsOpen(step) ? step.Value : "");
        text = Runners().Replace(text, "runners: " + string.Join(',', open.Select(step => $"step{step}")));
        return Matrix().Replace(text, $"STEP: [{string.Join(", ", open)}]");

        bool IsOpen(Match step) => open.Contains(int.Parse(step.Groups["step"].Value));
    }

    [GeneratedRegex(@"^## Step (?<step>\d+): .*\S", RegexOptions.Multiline)]
    private static partial Regex Heading();

    [GeneratedRegex("^## How to work", RegexOptions.Multiline)]
    private static partial Regex HowToWork();

    /// <summary>Of the classroom's workflow, what a step runs, up to an empty line, and where its result goes.</summary>
    [GeneratedRegex(@"^ +- id: step(?<step>\d+)\s*\n(?:.*\S.*\n)+\s*\n|^ +STEP(?<step>\d+)_RESULTS: .*\n", RegexOptions.Multiline)]
    private static partial Regex PartOfWorkflow();

    [GeneratedRegex(@"runners: step[\w,]+")]
    private static partial Regex Runners();

    [GeneratedRegex(@"STEP: \[[\d, ]+\]")]
    private static partial Regex Matrix();
}
