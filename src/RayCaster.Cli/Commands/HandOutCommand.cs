namespace RayCaster.Cli;

internal sealed class HandOutCommand() : Command("handout", "<folder>", "Writes the lab for students: ten steps, with tests.")
{
    private static readonly Option<NumberRange?> open = new("--open", "<steps>",
        "The steps that the students write, for example 1..4 or 7; the others are written already. [default: 1..10]",
        "one step of 1 to 10, or the first and the last as in 1..4", ReadSteps);
    private static readonly Option<bool> solution = Option.Switch("--solution", "All steps are written: for the teacher.");

    public override string Description =>
        "Writes a hand-out of the lab: a folder that is a course's repository. It has a program that draws from the first minute, ten steps to " +
        "write, tests for each step, and the picture of each scene after each step.";

    public override IReadOnlyList<(string, string)> Arguments => [("<folder>", "A new folder.")];

    public override Option[] Options => [open, solution, Option.Quiet];

    public override string[] Examples => ["handout ../lab1", "handout ../lab1-boxes --open 7"];

    public override int Run(CommandLine line)
    {
        var folder = line.Exactly("<folder>")[0];
        if (line.Get(solution) && line.Get(open) is not null)
            throw ProblemException.Usage("with '--solution' no step is open: leave '--open' out");
        var (first, last) = line.Get(solution) ? default : line.Get(open) ?? new(1, LabSteps.Count);
        HandOutFolder.Write(folder, step => first <= step && step <= last);
        var steps = last == 0 ? "all steps are done" : first == last ? $"step {first} is open" : $"steps {first} to {last} are open";
        line.Tell($"{folder}: {steps}; README.md says how to begin");
        return ExitCode.Done;
    }

    private static NumberRange? ReadSteps(string text) =>
        NumberRange.Parse(text.Contains("..") ? text : $"{text}..{text}") is { First: > 0 } steps && steps.Last <= LabSteps.Count ? steps : null;
}
