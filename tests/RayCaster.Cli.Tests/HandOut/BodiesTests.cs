using System.Text;
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

        """, Bodies.Parse("Circle.cs", File).With(_ => true));

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
    [InlineData("// BEGIN SOLUTION \"Circle\"\nx\n", "Circle.cs(1): error: the body that begins here has no // END SOLUTION")]
    [InlineData("x\n// END SOLUTION\n", "Circle.cs(2): error: a body ends here that has no // BEGIN SOLUTION")]
    [InlineData("// BEGIN SOLUTION \"Circle\"\n// BEGIN SOLUTION \"Ray\"\n",
        "Circle.cs(2): error: a body begins here, but that of line 1 has no // END SOLUTION")]
    [InlineData("// BEGIN SOLUTION Circle\n// END SOLUTION\n", "Circle.cs(1): error: after // BEGIN SOLUTION stands the slide's title in quotes")]
    [InlineData("// BEGIN SOLUTION \"Circel\"\n// END SOLUTION\n", "Circle.cs(1): error: no step has the slide \"Circel\"")]
    [InlineData("\n\n// STUB return 0;\n", "Circle.cs(3): error: a stub stands between // BEGIN SOLUTION and // END SOLUTION")]
    public void AMarkerOutOfPlaceIsAnErrorWithFileAndLine(string text, string message) =>
        Assert.Equal(message, Assert.Throws<ProblemException>(() => Bodies.Parse("Circle.cs", text)).Message);

    [Fact]
    public void OnlyTheOpenStepsHaveStubs()
    {
        var files = HandOutFiles.With(step => step is 3 or 9).ToDictionary(file => file.Path, file => Encoding.UTF8.GetString(file.Content));
        Assert.Contains("Todo.Note(\"Circle\");", files["src/Lab/Circle.cs"]);
        Assert.Contains("Todo.Note(\"Ray – Plane Intersection\");", files["src/Lab/Plane.cs"]);
        foreach (var (path, text) in files)
            if (path.StartsWith("src/Lab/") && path is not ("src/Lab/Circle.cs" or "src/Lab/Plane.cs" or "src/Lab/Todo.cs"))
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

        """, Bodies.Parse("Circle.cs", File).With(slide => slide == "Ray"));

    [Fact]
    public void TheLabHasNoConditionalCode() => // a beginner need not know it, and it would be handed out
        Assert.All(HandOutFiles.All().Where(file => file.Path.StartsWith("src/Lab/")),
            file => Assert.DoesNotMatch(@"(?m)^\s*#", Encoding.UTF8.GetString(file.Content)));

    [Fact]
    public void TheReadmeNamesEverySlideAndEveryStepsCommand()
    {
        var files = HandOutFiles.All().ToDictionary(file => file.Path, file => Encoding.UTF8.GetString(file.Content));
        var readme = files["README.md"];
        foreach (var (path, text) in files)
            if (path.StartsWith("src/Lab/") && path.EndsWith(".cs"))
                Assert.All(Bodies.Parse(path, text).All, body => Assert.Contains($"\"{body.Slide}\"", readme));
        for (var step = 1; step <= LabSteps.Count; step++) Assert.Contains($"    dotnet test --filter step={step}\n", readme);
    }
}
