using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests.HandOut;

/// <summary>The hand-out and the solution are one source.</summary>
public class BodiesTests
{
    private const string File = """
        class Circle
        {
            // BEGIN SOLUTION "Circle"
            return 1;
            // END SOLUTION

            // BEGIN SOLUTION "Ray"
            // STUB var t = 0;
            // STUB return t;
            return 2;
            // END SOLUTION
        }

        """;

    public static TheoryData<string> LabSources =>
        [.. Directory.EnumerateFiles(ProjectFolder.PathOf("src/RayCaster.Lab"), "*.cs").Select(file => Path.GetFileName(file))];

    [Fact]
    public void AnOpenBodyIsItsStubOrANote() => Assert.Equal("""
        class Circle
        {
            // BEGIN SOLUTION "Circle"
            Todo.Note("Circle");
            // END SOLUTION

            // BEGIN SOLUTION "Ray"
            var t = 0;
            return t;
            // END SOLUTION
        }

        """, Bodies.With("Circle.cs", File, _ => true));

    [Theory]
    [MemberData(nameof(LabSources))]
    public void WithAllBodiesPutBackTheHandOutIsTheSourceByteForByte(string name)
    {
        var source = System.IO.File.ReadAllText(ProjectFolder.PathOf($"src/RayCaster.Lab/{name}"));
        var handedOut = HandOutFiles.With(_ => true).Single(file => file.Path == "src/Lab/" + name).Content;
        var solved = HandOutFiles.With(_ => false).Single(file => file.Path == "src/Lab/" + name).Content;
        Assert.Equal(source, Encoding.UTF8.GetString(solved));
        var body = new Regex(@"(?<=// BEGIN SOLUTION[^\n]*\n).*?(?=[^\n]*// END SOLUTION)", RegexOptions.Singleline);
        var solutions = new Queue<Match>(body.Matches(source));
        Assert.Equal(source, body.Replace(Encoding.UTF8.GetString(handedOut), _ => solutions.Dequeue().Value));
    }

    [Theory]
    [InlineData("// BEGIN SOLUTION \"Circle\"\nx\n", 1)]
    [InlineData("x\n// END SOLUTION\n", 2)]
    [InlineData("// BEGIN SOLUTION \"Circle\"\n// BEGIN SOLUTION \"Ray\"\n// END SOLUTION\n", 1)]
    [InlineData("// BEGIN SOLUTION Circle\n// END SOLUTION\n", 1)]
    [InlineData("// BEGIN SOLUTION \"Ray\"\n// END SOLUTION\n// STUB return 0;\n", 3)]
    public void AMarkerOutOfPlaceIsAnErrorWithFileAndLine(string text, int line) => Assert.Equal(
        $"Circle.cs({line}): error: a body stands between // BEGIN SOLUTION \"slide\" and // END SOLUTION, and with it its // STUB",
        Assert.Throws<ProblemException>(() => Bodies.With("Circle.cs", text, _ => true)).Message);

    [Fact]
    public void AnUnknownSlideIsAnError() => Assert.Equal("Circle.cs: error: no step has the slide \"Circel\"",
        Assert.Throws<ProblemException>(() => Bodies.With("Circle.cs", "// BEGIN SOLUTION \"Circel\"\n// END SOLUTION\n", _ => true)).Message);

    [Fact]
    public void EachStepHasABody() => Assert.Equal(Enumerable.Range(1, LabSteps.Count), HandOutFiles.All()
        .Where(file => file.Path.StartsWith("src/Lab/")).SelectMany(file => SlidesOf(Encoding.UTF8.GetString(file.Content)))
        .Select(Slides.StepOf).Distinct().Order());

    [Fact]
    public void OnlyTheOpenStepsHaveStubs()
    {
        var files = HandOutFiles.With(step => step is 3 or 9).ToDictionary(file => file.Path, file => Encoding.UTF8.GetString(file.Content));
        Assert.Contains("Todo.Note(\"Circle\");", files["src/Lab/Circle.cs"]);
        Assert.Contains("Todo.Note(\"Ray – Plane Intersection\");", files["src/Lab/Plane.cs"]);
        foreach (var (path, text) in files)
            if (path.StartsWith("src/Lab/") && path is not ("src/Lab/Circle.cs" or "src/Lab/Plane.cs" or "src/Lab/Template/Todo.cs"))
                Assert.DoesNotMatch(@"SOLUTION|STUB|(?<!cref="")Todo\.Note", text);
    }

    [Fact]
    public void ASolvedBodyIsItsCodeWithoutMarkers() => Assert.Equal("""
        class Circle
        {
            return 1;

            // BEGIN SOLUTION "Ray"
            var t = 0;
            return t;
            // END SOLUTION
        }

        """, Bodies.With("Circle.cs", File, step => step == Slides.StepOf("Ray")));

    [Fact]
    public void TheLabHasNoConditionalCode() => // a beginner need not know it, and it would be handed out
        Assert.All(HandOutFiles.All().Where(file => file.Path.StartsWith("src/Lab/") && file.Path.EndsWith(".cs")),
            file => Assert.DoesNotMatch(@"(?m)^\s*#", Encoding.UTF8.GetString(file.Content)));

    [Fact]
    public void TheReadmeNamesEverySlideAndEveryStepsCommand()
    {
        var files = HandOutFiles.All().ToDictionary(file => file.Path, file => Encoding.UTF8.GetString(file.Content));
        var readme = files["README.md"];
        foreach (var (path, text) in files)
            if (path.StartsWith("src/Lab/") && path.EndsWith(".cs"))
                Assert.All(SlidesOf(text), slide => Assert.Contains($"\"{slide}\"", readme));
        for (var step = 1; step <= LabSteps.Count; step++) Assert.Contains($"    dotnet test --filter step={step}\n", readme);
    }

    private static IEnumerable<string> SlidesOf(string text) =>
        Regex.Matches(text, "// BEGIN SOLUTION \"(.+)\"").Select(begin => begin.Groups[1].Value);

    [Theory]
    [InlineData("a\r\nb\r\n", "a\nb\n")]
    [InlineData("ä\r\n", "ä\n")]
    [InlineData("a\rb\n", "a\rb\n")]
    [InlineData("\0\r\n", "\0\r\n")]
    public void ATextOfAHandOutEndsItsLinesWithLineFeeds(string content, string handedOut) =>
        Assert.Equal(handedOut, Encoding.UTF8.GetString(HandOutFiles.WithLineFeeds(Encoding.UTF8.GetBytes(content))));
}
