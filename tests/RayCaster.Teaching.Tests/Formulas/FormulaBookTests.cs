namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>The texts of the slides' formulas: each right style draws the definition's picture, and errors say where they are.</summary>
public class FormulaBookTests
{
    /// <summary>Scenes that have all shapes and both rules.</summary>
    private static readonly string[] some = ["room", "mistakes/generic", "mistakes/inside", "sample-center"];

    public static IEnumerable<TheoryDataRow<string>> Scenes => SceneFolder.Files("scenes").Concat(SceneFolder.Files("scenes/mistakes"))
        .Select(SceneFolder.NameOf).Select(name => new TheoryDataRow<string>(name) { Explicit = !some.Contains(name) });

    [Theory]
    [MemberData(nameof(Scenes))]
    public void EachSectionDrawsTheDefinitionsPicture(string name)
    {
        var scene = SceneFolder.Small(name, 8);
        var definition = Renderer.Render(scene);
        var slides = FormulaProgram.Slides;
        var evaluator = new FormulaEvaluator(
            scene, [.. Enumerable.Range(0, definition.Count).Select(i => (i % definition.Width, i / definition.Width))], slides);
        foreach (var kind in Enum.GetValues<StepKind>())
        {
            foreach (var section in FormulaBook.Slides.StylesOf(kind))
            {
                var evidence = new PictureSample(scene, definition, Picture(definition, evaluator.Draw(slides.With(section))), int.MaxValue);
                Assert.True(evidence.IsRight, $"{name}: the formulas of [{section.Name}] in src/RayCaster.Teaching/Formulas " +
                    $"and those of src/RayCaster draw {evidence.WrongCount} pixels differently");
            }
        }
    }

    [Theory]
    [InlineData("h: none = 2·tan(fov)", "unknown name 'fov'")]
    [InlineData("h: none = 2·(T - P)", "2·(T − P) is displacement, not none")]
    [InlineData("h: none = width + zNear", "the units on both sides of '+' differ: width is pixels and zNear is length")]
    [InlineData("h: none = zNear·zNear + zNear", "the units on both sides of '+' differ: zNear² is length² and zNear is length")]
    [InlineData("h: none = T + P", "the units on both sides of '+' differ: T is point and P is point")]
    [InlineData("h: none = up + 1", "'+' does not take such operands")]
    [InlineData("h: none = (2", "the expression ends too early")]
    [InlineData("h: none = 2 3", "'3' after the end of an expression")]
    [InlineData("h: none = P.w", "'.w'; a vector has .x, .y and .z")]
    [InlineData("h: metres = 2", "unknown unit 'metres'")]
    [InlineData("h = 2", "'h = 2' where 'name: unit = expression' is expected")]
    public void AnErrorNamesSectionAndLine(string line, string message)
    {
        var error = Assert.Throws<FormatException>(() => Book($"# the camera\n[camera] short\n{line}\n"));
        Assert.StartsWith($"Test.txt(3): [camera] short: {message}", error.Message, StringComparison.Ordinal);
    }

    private static FormulaBook Book(string text) => new([("Test.txt", text)]);

    private static Picture Picture(Picture size, byte[] bytes)
    {
        var picture = new Picture(size.Width, size.Height);
        bytes.CopyTo(picture.Rgb);
        return picture;
    }
}
