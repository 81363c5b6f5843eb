using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests.Docs;

/// <summary>The documents show what the program prints and draws.</summary>
public class DocsTests
{
    /// <summary>All pages but what is built; those of src/HandOut are written for the folder that is handed out.</summary>
    public static TheoryData<string> Documents => new(
        Directory.GetFiles(ProjectFolder.Root, "*.md", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(ProjectFolder.Root, file).Replace('\\', '/'))
            .Where(file => !Regex.IsMatch(file, "^src/HandOut/|/(bin|obj)/")));

    [Fact]
    public void AllPagesAreRead() =>
        Assert.Superset(
            new HashSet<string> { "README.md", "docs/limits.md", "src/RayCaster.Engine/README.md" },
            Documents.Select(file => file.Data).ToHashSet());

    [Theory]
    [MemberData(nameof(Documents))]
    public void EveryLinkLeadsToAFile(string document)
    {
        var folder = Path.GetDirectoryName(ProjectFolder.PathOf(document))!;
        foreach (Match link in Regex.Matches(Read(document), @"\]\((?!https?:)([^)#]+)[^)]*\)"))
        {
            var path = Path.Combine(folder, link.Groups[1].Value);
            Assert.True(File.Exists(path) || Directory.Exists(path), $"{document} links to {link.Groups[1].Value}, which is not there");
        }
    }

    [Fact]
    public void TheReadmeShowsTheFirstSceneInFull() => Assert.Contains($"```json\n{Read("scenes/first.json")}```", Read("README.md"));

    [Fact]
    public void TheExplanationOfTheDocumentIsTheOneThatIsPrinted()
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/first.json")).Scene!;
        var text = ExplanationText.Format(new PixelExplanation(scene, 250, 250));
        var shown = Regex.Match(Read("docs/explain.md"), @"-- explain scenes/first.json 250 250\n(.*?)```", RegexOptions.Singleline).Groups[1].Value;
        Assert.NotEmpty(shown);
        foreach (var line in shown.Split('\n').Where(line => line != "...")) Assert.Contains(line, text.ReplaceLineEndings("\n").Split('\n'));
    }

    [Theory]
    [InlineData("room", 500, 500)]
    [InlineData("first", 300, 200)]
    public void ThePicturesOfTheReadmeAreThoseOfTheScenes(string scene, int width, int height)
    {
        var read = SceneReader.Read(ProjectFolder.PathOf($"scenes/{scene}.json")).Scene!;
        var picture = ScalarRenderer.Render(read.WithSize(width, height));
        Assert.Equal(PictureFile.Read(ProjectFolder.PathOf($"docs/{scene}.png")).Rgb, picture.Rgb);
    }

    [Theory]
    [InlineData("Cylinder")]
    [InlineData("Tube")]
    public void TheShapesToAddAreThoseOfTheTests(string shape)
    {
        var code = Read($"tests/Testing/{shape}.cs");
        Assert.Contains(code[code.IndexOf("public ", StringComparison.Ordinal)..], Read("docs/adding-a-primitive.md"));
    }

    [Fact]
    public void TheShapeToAddIsTheSameInBothWays()
    {
        var camera = new Camera(new(5, 2, 3), Vector3.Zero) { Width = 60, Height = 40 };
        Assert.Equal(Drawn(new Cylinder(new(0.3, 0, 0), 1, 2)), Drawn(Model.Of(new Tube(new(0.3, 0, 0), 1, 2))));

        byte[] Drawn(Model model) => ScalarRenderer.Render(new(camera, [model], new(0, 0, 1))).Rgb;
    }

    [Theory]
    [InlineData("src/RayCaster.Lab/Sphere.cs")]
    [InlineData("src/RayCaster/Shapes/Sphere.cs")]
    public void TheSphereIsShownAsItIsWritten(string file)
    {
        var code = Read(file).Split('\n').Select(line => line.Split("//")[0].Trim()).ToHashSet();
        var blocks = Regex.Matches(Read("docs/lab-to-library.md"), @"```csharp\n(.*?)```", RegexOptions.Singleline);
        var shown = blocks[file.Contains("Lab", StringComparison.Ordinal) ? 0 : 1].Groups[1].Value;
        Assert.All(shown.Split('\n'), line => Assert.Contains(line.Trim(), code));
    }

    [Fact]
    public void TheReadmeShowsTheProgramThatTheTestsCompile()
    {
        var code = Read("tests/RayCaster.Cli.Tests/Docs/SceneInCode.cs");
        const string usings = "using RayCaster;\nusing RayCaster.Engine;\nusing RayCaster.Files;\n\n"; // the tests' project has them for all files
        var body = Regex.Match(code, @"Run\(\)\n    \{\n(.*)\n    \}", RegexOptions.Singleline).Groups[1].Value;
        Assert.Contains($"```csharp\n{usings}{Regex.Replace(body, "^ {8}", "", RegexOptions.Multiline)}\n```", Read("README.md"));
    }

    [Fact]
    public void TheProgramOfTheReadmeWritesThePictureOfTheFirstScene()
    {
        using var folder = new TemporaryFolder();
        SameProcess.In(folder.Path, SceneInCode.Run);
        var first = SceneReader.Read(ProjectFolder.PathOf("scenes/first.json")).Scene!;
        Assert.Equal(ScalarRenderer.Render(first).Rgb, PictureFile.Read(folder["first.png"]).Rgb);
    }

    /// <summary>The table of slides names members of the file that it links to.</summary>
    [Fact]
    public void TheFormulasOfTheSlidesAreWhereThePageSays()
    {
        var named = Regex.Matches(Read("docs/slides-to-code.md"), @"\]\(\.\./(src/[^)]+\.cs)\): ([^|\[\n]+)");
        Assert.NotEmpty(named);
        foreach (Match place in named)
            foreach (Match member in Regex.Matches(place.Groups[2].Value, @"`(\w+)`"))
                Assert.Matches($@"\b{member.Groups[1].Value}\b", Read(place.Groups[1].Value));
    }

    private static string Read(string file) => File.ReadAllText(ProjectFolder.PathOf(file)).ReplaceLineEndings("\n");
}
