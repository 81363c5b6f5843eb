using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests.HandOut;

/// <summary>The README and the workflows of a hand-out are about its open steps.</summary>
public class OpenStepsTests
{
    private static Dictionary<string, string> With(Func<int, bool> isOpen) =>
        HandOutFiles.With(isOpen).ToDictionary(file => file.Path, file => Encoding.UTF8.GetString(file.Content));

    private static string[] Numbers(string text, string pattern) =>
        [.. Regex.Matches(text, pattern).Select(match => match.Groups[1].Value)];

    [Fact]
    public void TheReadmeSaysWhichStepsAreDone()
    {
        var readme = With(step => step is 3 or 9)["README.md"];
        Assert.Contains("\n\n**You write the steps 3, 9.** The others are written already", readme);
        Assert.Contains("your program draws what they add, too: the pictures below of your steps lack it.\n\n## How to work", readme);
        Assert.Equal(["1", "2", "4", "5", "6", "7", "8", "10"], Numbers(readme, @"(?m)^## Step (\d+): .* \(done already\)$"));
        Assert.Contains("\n\n**You write step 7.** ", With(step => step == 7)["README.md"]);
    }

    [Fact]
    public void TheReadmeHasThePointsOfTheOpenSteps()
    {
        Assert.Contains("\n| step | points |\n|---|--:|\n| 3 plane | 10 |\n| 9 circle | 10 |\n\n", With(step => step is 3 or 9)["README.md"]);
        Assert.Equal(LabSteps.Count, Numbers(With(_ => false)["README.md"], @"(?m)^\| (\d+) .* \| 10 \|$").Length);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 5)]
    [InlineData(10, 10)]
    public void TheWorkflowsHaveTheOpenStepsOnly(int first, int last)
    {
        string[] open = [.. Enumerable.Range(first, last - first + 1).Select(step => step.ToString())];
        var files = With(step => first <= step && step <= last);
        var classroom = files[".github/workflows/classroom.yml"];
        foreach (var part in (string[])[
            @"- id: step(\d+)\n        uses: .*\n        with:\n(?:          .*\n){4}\n", @"test-name: ""(\d+) ", @"--filter step=(\d+) ",
            @"  STEP(\d+)_RESULTS: ", @"steps\.step(\d+)\.", @"(?<=runners: \S*)step(\d+)"])
            Assert.Equal(open, Numbers(classroom, part));
        Assert.Contains("- run: dotnet build\n\n      - id: step", classroom);
        Assert.Contains("\n\n      - uses: classroom-resources/autograding-grading-reporter@", classroom);
        Assert.Contains($"STEP: [{string.Join(", ", open)}]\n", files[".gitlab-ci.yml"]);
    }

    [Fact]
    public void WithAllStepsOpenOrNoneTheTextsAreTheSame()
    {
        var (all, none) = (With(_ => true), With(_ => false));
        Assert.All(all.Where(file => OpenSteps.Concern(file.Key)), file => Assert.Equal(file.Value, none[file.Key]));
        Assert.DoesNotContain("done already", all["README.md"]);
    }
}
