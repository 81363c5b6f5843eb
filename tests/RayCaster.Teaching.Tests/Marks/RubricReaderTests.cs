namespace RayCaster.Teaching.Tests.Marks;

public sealed class RubricReaderTests : InTemporaryFolder
{
    public RubricReaderTests() => folder.Write("room.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json")));

    private Rubric? Read(string text, out string report) => RubricReader.Read(folder.Write("rubric.json", text), out report);

    private string ErrorOf(string text)
    {
        Assert.Null(Read(text, out var report));
        return report.Split('\n')[0].Replace(folder.Path + Path.DirectorySeparatorChar, "");
    }

    [Fact]
    public void TheRubricOfTheTenStepsHasNoErrorAndTenItems()
    {
        var rubric = RubricReader.Read(ProjectFolder.PathOf("docs/rubric.json"), out var report);
        Assert.Equal("", report);
        Assert.Equal((10, 20.0, 8), (rubric!.Items.Count, rubric.Points, rubric.Scenes.Count));
    }

    [Fact]
    public void TheRubricOfTheTenStepsHasAnItemForEachMistakeBeyondRounding()
    {
        var rubric = RubricReader.Read(ProjectFolder.PathOf("docs/rubric.json"), out var report);
        Assert.True(rubric is not null, report);
        var beyond = MistakeCatalog.All.Where(mistake => !mistake.IsWithinRounding).Select(mistake => mistake.Id);
        Assert.Equal(beyond.Order(), rubric.Items.SelectMany(item => item.Mistakes).Order());
    }

    [Fact]
    public void TheSchemaOfRubricsSaysWhatTheReaderReads()
    {
        var (file, schema) = (RubricSchema.File, RubricSchema.Write());
        Assert.True(File.Exists(file) && File.ReadAllText(file).ReplaceLineEndings("\n") == schema,
            $"{file} is not what the reader says; dotnet run --project tests/Tools/Generator writes it anew");
    }

    [Theory]
    [InlineData("\"step\": 7", "items[0] has a step, which needs tests: the file of test results in a student's folder")]
    [InlineData("\"by\": \"tests\"", "items[0].by needs step: the step of the hand-out whose tests decide")]
    public void TestsNeedAFileAndAStep(string item, string error) =>
        Assert.Contains(error, ErrorOf($$"""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1, {{item}} }] }"""));

    [Fact]
    public void WhatIsLeftOutHasADefault()
    {
        var rubric = Read("""{ "scenes": ["room.json"], "items": [{ "name": "all", "points": 3, "mistakes": ["r-nosq"] }] }""", out var report);
        Assert.Equal("", report);
        Assert.Equal(("Marks", HintLevel.Question, "{name}.png"), (rubric!.Title, rubric.Hint, rubric.Pictures));
        Assert.Equal(3, rubric.Items[0].Each);
    }

    [Fact]
    public void TheErrorOfASceneInAnotherFolderHasThePlainPath()
    {
        Directory.CreateDirectory(folder["marks"]);
        folder.Write("rum.json", "{ ]");
        var rubric = folder.Write("marks/rubric.json", """{ "scenes": ["../rum.json"], "items": [{ "name": "a", "points": 1 }] }""");
        Assert.Null(RubricReader.Read(rubric, out var report));
        Assert.Contains($"\n{folder["rum.json"]}(1,3): error: ", report);
        Assert.Null(RubricReader.Read(Path.GetRelativePath(".", rubric), out report));
        Assert.Contains($"\n{Path.GetRelativePath(".", folder["rum.json"])}(1,3): error: ", report);
    }

    [Fact]
    public void ABackslashThatIsWrittenOnceIsNamed() => Assert.EndsWith(
        @" error: tests: \r in a text is a control character: write / or \\ between folders", ErrorOf(
            """{ "scenes": ["room.json"], "tests": "TestResults\results.xml", "items": [{ "name": "a", "points": 1 }] }"""));

    [Fact]
    public void BackslashesMaySeparateFolders() => Assert.Equal(("out/{name}.png", "TestResults/results.xml"), Read(
        """
        { "scenes": ["room.json"], "pictures": "out\\{name}.png", "tests": "TestResults\\results.xml",
          "items": [{ "name": "a", "points": 1, "mistakes": ["r-nosq"] }] }
        """, out _) is { } rubric ? (rubric.Pictures, rubric.Tests) : default);

    [Theory]
    [InlineData("""{ "scenes": ["a\u0000.json"], "items": [{ "name": "a", "points": 1 }] }""", "scenes[0]")]
    [InlineData("""{ "scenes": ["room.json"], "pictures": "\u0000{name}.png", "items": [{ "name": "a", "points": 1 }] }""", "pictures")]
    [InlineData("""{ "scenes": ["room.json"], "tests": "\u0000.xml", "items": [{ "name": "a", "points": 1 }] }""", "tests")]
    public void ANameThatNoFileCanHaveIsRefused(string rubric, string place)
    {
        Assert.Null(Read(rubric, out var report));
        Assert.Contains($" error: {place} must not hold the character U+0000, which no file name has\n", report);
    }

    [Theory]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1, "mistakes": ["r-nosqr"] }] }""",
        "rubric.json(1,79): error: items[0].mistakes[0] must be the id of a known mistake, but is \"r-nosqr\"; did you mean \"r-nosq\"?")]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1, "undone": ["spere"] }] }""",
        "rubric.json(1,77): error: items[0].undone[0] must be one of plane, sphere, aabb, circle, triangle, mesh, attenuation, clipping, " +
            "but is \"spere\"; did you mean \"sphere\"?")]
    [InlineData("""{ "pictures": "mine.png", "scenes": ["room.json", "room.json"], "items": [{ "name": "a", "points": 1 }] }""",
        "rubric.json(1,15): error: pictures must contain {name}, the scene's name, since there are 2 scenes")]
    [InlineData("""{ "scenes": ["rom.json"], "items": [{ "name": "a", "points": 1 }] }""",
        "rubric.json(1,14): error: scenes[0] cannot be used: rom.json has errors")]
    [InlineData("""{ "scenes": ["room.json"], "items": [] }""", "rubric.json(1,37): error: items must hold at least one item")]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1, "mistakes": ["rad"] }, """ +
        """{ "name": "b", "points": 1, "mistakes": ["rad"] }] }""",
        "rubric.json(1,130): error: items[1].mistakes[0] is rad, which costs points of \"a\" already: a mistake belongs to one item")]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1 }, { "name": "a", "points": 2 }] }""",
        "rubric.json(1,78): error: items[1].name is \"a\", which another item is called already: tables and pages tell items apart by their names")]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1, "each": 1.5 }] }""",
        "rubric.json(1,74): error: items[0].each must be at most the item's points, 1, but is 1.5")]
    [InlineData("""{ "scenes": [""], "items": [{ "name": "a", "points": 1 }] }""",
        "rubric.json(1,14): error: scenes[0] must be the path of a scene file, but is \"\"")]
    [InlineData("""{ "pictures": "", "scenes": ["room.json"], "items": [{ "name": "a", "points": 1 }] }""",
        "rubric.json(1,15): error: pictures must be the path of a picture, but is \"\"")]
    [InlineData("""{ "scenes": ["room.json"], "items": [{ "name": "a", "points": 1e308 }] }""",
        "rubric.json(1,63): error: items[0].points must be from 0.01 to 10000, but is 1e308")]
    public void AnErrorIsToldWithItsPlaceAndTheWayOut(string text, string error) => Assert.Equal(error, ErrorOf(text));
}
