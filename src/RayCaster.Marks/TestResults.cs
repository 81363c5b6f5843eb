namespace RayCaster.Marks;

/// <summary>How many tests of a step pass, and of how many that ran.</summary>
/// <param name="IsOpen">Whether tests of one name alone decide if all pass, and end in different ways.</param>
internal sealed record StepResult(int Step, int Passed, int Count, bool IsOpen = false)
{
    public bool IsPassed => Passed == Count;

    /// <summary>Whether the result is about this step: tests fail, too, if a step fails that they use.</summary>
    public bool IsConclusive(IReadOnlyDictionary<int, StepResult> all) =>
        !IsOpen && (IsPassed || !Enumerable.Range(1, Step is 4 or 5 ? 3 : 2)
            .Any(used => used < Step && all.GetValueOrDefault(used) is { IsPassed: false }));

    public override string ToString() => $"{Passed} of {Count} tests of step {Step} pass";
}

/// <summary>The results of a student's tests.</summary>
/// <param name="Steps">By step; without those of which no test ran.</param>
/// <param name="Notes">What the results do not say, and why, for the teacher and the student.</param>
/// <param name="HasFiles">Whether there are any, even if they cannot be read.</param>
internal sealed record TestResults(IReadOnlyDictionary<int, StepResult> Steps, IReadOnlyList<string> Notes, bool HasFiles)
{
    private const int MaxNamed = 3;

    /// <summary>The hand-out's tests of whole pictures are called so. They show the mistakes of all steps before, and do not count.</summary>
    private const string OfPictures = "ThePictures";

    public static TestResults In(Submission submission, Rubric rubric)
    {
        var (all, notes) = (new List<(string File, ReportedTest Test)>(), new List<string>());
        var files = submission.FilesLike(rubric.Tests!);
        foreach (var file in files)
        {
            try
            {
                if (submission.LinkIn(file) is not null) throw new ProblemException("a link leads to it, perhaps into another student's folder");
                var read = TestReport.Read(Path.Combine(submission.Folder, file));
                all.AddRange(read.Select(test => (PrintableText.From(file), test)));
                if (read.All(test => test.Step == 0))
                    notes.Add($"the test results {PrintableText.From(file)} count for no step: JUnit must name it in a test's class or name, " +
                        $"as in Step08Sphere and test_step_8, but none of {read.Count} does");
            }
            catch (ProblemException e)
            {
                notes.Add($"the test results {PrintableText.From(file)} cannot be read: {e.Message}");
            }
        }
        if (files.Count == 0 && rubric.Items.Any(item => item.Evidence == ItemEvidence.Tests))
            notes.Add($"there are no test results {rubric.Tests}");
        var steps = rubric.Items.Where(item => item.Evidence != ItemEvidence.Pictures).Select(item => item.Step).Distinct().Order().ToArray();
        var tests = Joined(all, notes);
        return new(ByStep(tests), [.. notes, .. NotesOn(tests, steps)], files.Count > 0);
    }

    /// <summary>The tests of all files: one that several runs have counts once, as in the run that began last.</summary>
    /// <param name="notes">Gets what the files say differently where no time says which run is the last.</param>
    internal static List<ReportedTest> Joined(IReadOnlyList<(string File, ReportedTest Test)> all, List<string> notes)
    {
        var tests = new List<ReportedTest>();
        foreach (var same in all.GroupBy(row => row.Test.Key))
        {
            var runs = same.GroupBy(row => row.File, row => row.Test).ToArray();
            var newest = runs.GroupBy(run => run.Max(test => test.Begun)).MaxBy(time => time.Key)!;
            ReportedTest[][] last = [.. newest.Select(run => run.ToArray())];
            if (runs.Any(run => run.Any(test => test.Begun is null))) last = [.. runs.Select(run => run.ToArray())];
            var isCut = last.Length == 1 && same.Key.Contains("···"); // xunit cuts long names, so these are several tests
            var isDisputed = !isCut && last.SelectMany(run => run).Select(test => test.Outcome).Except([TestOutcome.NotRun]).Count() > 1;
            tests.AddRange((isDisputed ? last.SelectMany(run => run) : last[0]).Select(test => test with { IsDisputed = isDisputed }));
            if (isDisputed && last.Length > 1)
                notes.Add($"{string.Join(" and ", runs.Select(run => run.Key))} disagree about a test of step {last[0][0].Step}, " +
                    $"{PrintableText.From(last[0][0].Name)}, and no time says which run is the last");
        }
        return tests;
    }

    /// <returns>Of a run that was stopped, only the steps that fail: tests of the others may be missing.</returns>
    internal static IReadOnlyDictionary<int, StepResult> ByStep(IReadOnlyList<ReportedTest> tests) =>
        tests.Where(test => test.Outcome != TestOutcome.NotRun && test.Step > 0 && !test.Name.StartsWith(OfPictures, StringComparison.Ordinal))
            .GroupBy(test => test.Step)
            .Select(step => new StepResult(step.Key, step.Count(test => test.Outcome == TestOutcome.Passed), step.Count(),
                step.Any(test => test.IsDisputed) && step.All(test => test.IsDisputed || test.Outcome == TestOutcome.Passed)))
            .Where(step => !step.IsPassed || !tests.Any(test => test.IsStopped)).ToDictionary(step => step.Step);

    /// <summary>What else must be known of the tests of some steps.</summary>
    internal static IEnumerable<string> NotesOn(IReadOnlyList<ReportedTest> tests, int[] steps)
    {
        if (tests.Any(test => test.IsStopped)) yield return "the test run was stopped, so only steps count whose tests fail";
        else if (steps.Except(tests.Select(test => test.Step)).ToArray() is { Length: > 0 } missing && tests.Any(test => test.Step > 0))
            yield return $"the test results have no test of step {string.Join(", ", missing)}";
        if (tests.Any(test => test.Name == "" && test.Outcome == TestOutcome.NotRun))
            yield return "the test results count tests that did not run, but do not list them";
        foreach (var step in tests.GroupBy(test => test.Step).Where(step => steps.Contains(step.Key)).OrderBy(step => step.Key))
        {
            if (step.Where(test => test.Outcome == TestOutcome.NotRun).ToArray() is { Length: > 0 } idle)
                yield return $"{idle.Length} of {step.Count()} tests of step {step.Key} did not run ({Listed(idle.Select(test => test.Word))})";
            foreach (var same in step.Where(test => test.IsDisputed).GroupBy(test => (test.Key, test.Name)))
                yield return $"{same.Count(test => test.Outcome == TestOutcome.Failed)} of {same.Count()} tests called " +
                    $"{PrintableText.From(same.Key.Name)} fails, in step {step.Key}";
            if (step.Where(test => test.IsFlaky).ToArray() is { Length: > 0 } flaky)
                yield return $"flaky tests of step {step.Key}, whose last attempt counts: {Listed(flaky.Select(test => test.Name))}";
        }
    }

    private static string Listed(IEnumerable<string> all) => all.Select(text => PrintableText.From(text)).Distinct().ToArray() is var texts
        && texts.Length > MaxNamed ? $"{string.Join(", ", texts.Take(MaxNamed))} and {texts.Length - MaxNamed} more" : string.Join(", ", texts);
}
