
namespace RayCaster.Teaching.Tests.Course;

/// <summary>What "--pixel" of a hand-out prints, whatever mistake is in the student's file.</summary>
public class PixelNumbersTests
{
    private static readonly Scene room = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;

    /// <summary>The ball shows in this pixel.</summary>
    private static string[] Numbers(string file, string old, string @new, string hint = "answer", double? limit = null) =>
        EditedLab.PixelOf(room, 325, 359, hint, file, old, @new, limit).Split('\n', StringSplitOptions.RemoveEmptyEntries);

    private static void AssertHas(string line, string[] lines) =>
        Assert.True(lines.Contains(line), $"expected the line\n{line}\nin\n{string.Join('\n', lines)}");

    private static string FirstWrong(string[] lines) =>
        lines.FirstOrDefault(line => line.Contains("yours")) ?? $"no number is wrong in\n{string.Join('\n', lines)}";

    [Fact]
    public void OfRightBodiesNoNumberIsWrong()
    {
        var lines = Numbers("Camera", "W = ", "W = ");
        Assert.Equal("Column 325, line 359 from the top: c = 325, r = 140", lines[0]);
        AssertHas("  uc (from your d): 0.124264", lines);
        AssertHas("  t of ball: 17.0344", lines);
        AssertHas("  bytes: (146, 146, 0)", lines);
        Assert.Equal("None of these numbers is wrong.", lines[^1]);
    }

    [Theory]
    [InlineData("Vector3", "a.Y * b.Z - a.Z * b.Y", "a.Z * b.Y - a.Y * b.Z", "a × b for a = (1, 2, 3), b = (4, −5, 6)", "IDE & Vectors")]
    [InlineData("Vector3", "Math.Sqrt(this * this)", "this * this", "|a| for a = (1, 2, 3), b = (4, −5, 6)", "IDE & Vectors", Explicit = true)]
    [InlineData("Camera", "W = -(Target", "W = (Target", "W", "Camera", Explicit = true)]
    [InlineData("Camera", "U = (Up % W).Normalized", "U = (W % Up).Normalized", "U", "Camera", Explicit = true)]
    [InlineData("Camera", "V = W % U", "V = U % W", "V", "Camera", Explicit = true)]
    [InlineData("Camera", "fovY / 2 * Math.PI / 180", "fovY / 2", "h", "Camera", Explicit = true)]
    [InlineData("Camera", "h * Width / Height", "h * Width", "w", "Camera", Explicit = true)]
    [InlineData("Camera", "- w / 2", "- w", "uc (from your d)", "Camera Pixel Translation", Explicit = true)]
    [InlineData("Camera", "r / Height - h / 2", "c / Height - h / 2", "ur (from your d)", "Camera Pixel Translation", Explicit = true)]
    [InlineData("Camera", "(uc * U + ur * V - W).Normalized", "uc * U + ur * V - W", "d", "Camera Pixel Translation", Explicit = true)]
    [InlineData("Camera", "ur * V - W", "ur * V + W", "d", "Camera Pixel Translation", Explicit = true)]
    [InlineData("Plane", "(Q - ray.Origin)", "(ray.Origin - Q)", "t of back", "Ray – Plane Intersection")]
    [InlineData("Sphere", "R * R - D * D", "R - D * D", "t of ball", "Sphere – Geometric Solution", Explicit = true)]
    [InlineData("Circle", ".Length <= R", ".Length >= 0", "t of disc", "Circle")] // no hit is right
    [InlineData("Ray", "t >= HitParameter", "t <= HitParameter", "hit", "Ray", Explicit = true)]
    [InlineData("Ray", "t > Bias", "t < Bias", "Counts(25.601)", "Bias\" or \"zNear & zFar", Explicit = true)]
    [InlineData("Ray", "z <= ZFar", "z <= ZNear", "Counts(25.601)", "Bias\" or \"zNear & zFar", Explicit = true)]
    [InlineData("Camera", "(2 * (Target", "((Target", "attenuation", "Primitive Shading")]
    [InlineData("Sphere", "2 * (ray.Direction * CP)", "ray.Direction * CP", "t of ball by AnalyticalSolution",
        "Sphere – Analytical Solution", Explicit = true)]
    [InlineData("Vector3", "return new(a.X + b.X, a.Y + b.Y, a.Z + b.Z)", "a.X += b.X; a.Y += b.Y; a.Z += b.Z; return a",
        "a after a + b", "IDE & Vectors")]
    [InlineData("Scene", ": Camera.Shade(ray)", ": ray.HitModel.Color", "bytes", "Ray Casting")]
    public void TheFirstWrongNumberIsThatOfTheMistake(string file, string old, string @new, string name, string slide)
    {
        var first = FirstWrong(Numbers(file, old, @new));
        Assert.StartsWith($"  {name}: yours ", first);
        Assert.EndsWith($": the first wrong value. Slide \"{slide}\"", first);
    }

    [Fact]
    public void TheLevelOfTheHintDecidesWhatIsShown()
    {
        Assert.Equal("  ur (from your d): yours 0.23196, right −0.182254: the first wrong value. Slide \"Camera Pixel Translation\"", Of("answer"));
        Assert.Equal("  ur (from your d): yours 0.23196, not right: the first wrong value. Slide \"Camera Pixel Translation\"", Of("question"));
        Assert.Equal("  ur (from your d): yours 0.23196, not right: the first wrong value", Of("symptom"));

        static string Of(string hint) =>
            Numbers("Camera", "h * r / Height - h / 2", "h * r / Height", hint)
                .Single(line => line.StartsWith("  ur (from your d): ", StringComparison.Ordinal));
    }

    [Fact]
    public void WhatIsNotWrittenIsNotWrong()
    {
        var lines = Numbers("Sphere", "var L = C - ray.Origin;", "Todo.Note(\"Sphere – Geometric Solution\"); return; var L = C - ray.Origin;");
        AssertHas("  t of ball: not written yet. Step 8, slide \"Sphere – Geometric Solution\"", lines);
        AssertHas("  hit: back at t = 25.601", lines);
        Assert.Equal("None of these numbers is wrong.", lines[^1]);
        lines = Numbers("Camera", "W = -(", "Todo.Note(\"Camera\"); W = (");
        Assert.Equal(["  W: not written yet. Step 4, slide \"Camera\""], lines[1..2]);
        lines = Numbers("Vector3", "return new(a.X - b.X", "return Todo.Note(\"IDE & Vectors\", Zero); return new(a.X - b.X");
        Assert.Equal(["  W: not written yet. Step 1, slide \"IDE & Vectors\"", "None of these numbers is wrong."], lines[1..]);
        lines = Numbers("Camera", "var attenuation =", "return Todo.Note(\"Primitive Shading\", ray.HitModel.Color); var attenuation =");
        AssertHas("  bytes: (255, 255, 0)", lines);
        Assert.Equal("None of these numbers is wrong.", lines[^1]);
    }

    [Fact]
    public void ABodyThatThrowsIsTold()
    {
        var first = FirstWrong(Numbers("Sphere", "var t_ca = ", "throw new DivideByZeroException(); var t_ca = "));
        Assert.StartsWith("  t of ball: yours DivideByZeroException, ", first);
        Assert.Contains(", right 17.0344: the first wrong value", first);
    }

    [Fact]
    public void WhatNeedsTheResultOfABodyThatThrowsIsNotTold()
    {
        var lines = Numbers("Camera", "W = -(Target", "throw new Exception(\"one\\ntwo\"); W = -(Target");
        Assert.StartsWith("  W: yours Exception, one two", lines[1]);
        Assert.EndsWith(", right (1, 0, 0): the first wrong value. Slide \"Camera\"", lines[1]);
        Assert.Equal(3, lines.Length);
        lines = Numbers("Camera", "var ur =", "throw new Exception(); var ur =");
        Assert.StartsWith("  d: yours Exception, ", lines[^2]);
        lines = Numbers("Sphere", "var t_ca = ", "throw new Exception(); var t_ca = ");
        Assert.StartsWith("  bytes: yours Exception, ", lines[^2]);
    }

    [Fact]
    public void WhereABodyThrowsNoHitIsRightInWords()
    {
        var lines = Numbers("Circle", "var X = ray.At(t)", "Vector3 X = null");
        Assert.EndsWith(", right no hit: the first wrong value. Slide \"Circle\"", FirstWrong(lines));
    }

    [Fact]
    public void ABodyThatDoesNotEndIsTold()
    {
        var lines = Numbers("Camera", "var ur = ", "while (c > 0) Thread.Sleep(20); var ur = ", limit: 0.2);
        Assert.Equal("  w: 0.828427", lines[^3]);
        Assert.StartsWith("  uc (from your d): yours no end: probably your code has an endless loop, right 0.124264: the first wrong", lines[^2]);
    }

    [Theory]
    [InlineData("500", "0")]
    [InlineData("0", "-1")]
    [InlineData("a", "0")]
    [InlineData("0", "0", "--hint")]
    [InlineData("0", "0", "--hint", "all")]
    public void AnotherPixelOrHintIsAnError(params string[] pixel)
    {
        using var output = new StringWriter();
        Assert.Equal(2, PixelNumbers.Print(output, room, pixel, (_, _) => [], () => []));
        Assert.StartsWith("After --pixel write a column from 0 to 499, a line from 0 to 499, counted from the top", output.ToString());
    }
}
