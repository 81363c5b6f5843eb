namespace RayCaster.Cli;

internal sealed class HandOutCommand : Command
{
    public override string Help => """
        Description:
          Writes a hand-out of the lab: a folder that is a course's repository. It has a program that
          draws from the first minute, ten steps to write, tests for each step, and the picture of
          each scene after each step.

        Usage:
          raycaster handout <folder> [options]

        Arguments:
          <folder>  A new folder.

        Options:
              --open <steps>  The steps that the students write, for example 1..4 or 7; the others
                              are written already. [default: 1..10]
              --solution      All steps are written: for the teacher.
          -q, --quiet         Prints errors only.

        Examples:
          dotnet run --project src/RayCaster.Cli -- handout ../lab1
          dotnet run --project src/RayCaster.Cli -- handout ../lab1-boxes --open 7
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var folder = line.Exactly("<folder>")[0];
        var (first, last) = OpenSteps(line);
        HandOutFolder.Write(folder, step => first <= step && step <= last, cancellation);
        var steps = last == 0 ? "all steps are done" : first == last ? $"step {first} is open" : $"steps {first} to {last} are open";
        line.Tell($"{folder}: {steps}; README.md says how to begin");
        return ExitCode.Done;
    }

    private static LineRange OpenSteps(CommandLine line)
    {
        if (line.Has(Option.Solution))
            return line.Has(Option.Open) ? throw ProblemException.Usage("with '--solution' no step is open: leave '--open' out") : default;
        if (line[Option.Open] is not { } text) return new(1, LabSteps.Count);
        return LineRange.Parse(text.Contains("..") ? text : $"{text}..{text}") is { First: > 0 } steps && steps.Last <= LabSteps.Count ? steps
            : throw ProblemException.Usage(
                $"'{text}' names no steps: write one from 1 to {LabSteps.Count}, or the first and the last as in 1..4");
    }
}
