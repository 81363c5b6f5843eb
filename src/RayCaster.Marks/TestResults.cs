namespace RayCaster.Marks;

/// <summary>How many tests of a step pass, and of how many that ran.</summary>
internal sealed record StepResult(int Step, int Passed, int Count)
{
    public bool IsPassed => Passed == Count;

    /// <summary>Whether the result is about this step: tests fail, too, if a step fails that they use.</summary>
    public bool IsConclusive(IReadOnlyDictionary<int, StepResult> all) =>
        IsPassed || !Enumerable.Range(1, Step is 4 or 5 ? 3 : 2).Any(used => used < Step && all.GetValueOrDefault(used) is { IsPassed: false });

    public override string ToString() => $"{Passed} of {Count} tests of step {Step} pass";
}

/// <summary>The results of a student's tests.</summary>
/// <param name="Steps">By step; without those of which no test ran.</param>
/// <param name="Notes">What the results do not say, and why, for the teacher and the student.</param>
internal sealed record TestResults(IReadOnlyDictionary<int, StepResult> Steps, IReadOnlyList<string> Notes)
{
    private const int MaxNamed = 3;

    /// <summary>The hand-out's tests of whole pictures are called so. They show the mistakes of all steps before, and do not count.</summary>
    private const string OfPictures = "ThePictures";

    public static TestResults In(Submission submission, Rubric rubric)
    {
        var (tests, notes) = (new List<ReportedTest>(), new List<string>());
        var files = submission.FilesLike(rubric.Tests!);
        foreach (var file in files)
        {
            try
            {
                if (submission.LinkIn(file) is not null) throw new ProblemException("a link leads to it, perhaps into another student's folder");
                var read = TestReport.Read(Path.Combine(submission.Folder, file));
                tests.AddRange(read);
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
        return new(ByStep(tests), [.. notes, .. NotesOn(tests, steps)]);
    }

    /// <returns>Of a run that was stopped, only the steps that fail: tests of the others may be missing.</returns>
    internal static IReadOnlyDictionary<int, StepResult> ByStep(IReadOnlyList<ReportedTest> tests) =>
        tests.Where(test => test.Outcome != TestOutcome.NotRun && test.Step > 0 && !test.Name.StartsWith(OfPictures, StringComparison.Ordinal))
            .GroupBy(test => test.Step)
            .Select(step => new StepResult(step.Key, step.Count(test => test.Outcome == TestOutcome.Passed), step.Count()))
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
            if (step.Where(test => test.IsFlaky).ToArray() is { Length: > 0 } flaky)
                yield return $"flaky tests of step {step.Key}, whose last attempt counts: {Listed(flaky.Select(test => test.Name))}";
        }
    }

    private static string Listed(IEnumerable<string> all) => all.Select(text => PrintableText.From(text)).Distinct().ToArray() is var texts
        && texts.Length > MaxNamed ? $"{string.Join(", ", texts.Take(MaxNamed))} and {texts.Length - MaxNamed} more" : string.Join(", ", texts);
}
