
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
        Assert.Equal("Your numbers of the steps 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 are right for this pixel. The tests of step 10 ask more.", lines[^1]);
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
    [InlineData("Plane", "(Q - ray.Origin)", "(ray.Origin - Q)",
        "t of a plane with Q = (3, 3, −1), n = (1, 2, −1) for P = (1, 2, 3), d = (0.48, 0.6, −0.64)", "Ray – Plane Intersection")]
    [InlineData("Sphere", "R * R - D * D", "R - D * D", "t of ball", "Sphere – Geometric Solution", Explicit = true)]
    [InlineData("Circle", ".Length <= R", ".Length >= 0", "t of disc", "Circle")] // no hit is right
    [InlineData("Ray", "t >= HitParameter", "t <= HitParameter", "HitParameter and HitModel after Hit(5), Hit(3), Hit(4)", "Ray", Explicit = true)]
    [InlineData("Ray", "t > Bias", "t < Bias", "isAhead of Counts(1) for Bias = 2", "Bias")]
    [InlineData("Ray", "z <= ZFar", "z <= ZNear", "isBetween of Counts(10) for ZNear = 3, ZFar = 7, DepthPerT = 0.5", "zNear & zFar")]
    [InlineData("Ray", "var z = t * DepthPerT", "var z = t / DepthPerT",
        "isBetween of Counts(10) for ZNear = 3, ZFar = 7, DepthPerT = 0.5", "zNear & zFar", Explicit = true)]
    [InlineData("Ray", "Origin + t * Direction", "t * Origin + Direction", "X(5) for P = (1, 2, 3), d = (0.48, 0.6, −0.64)", "Ray")]
    [InlineData("Aabb", "B0 <= P && P <= B1", "true", "Slab(1, 3, 0, 0)", "AABB – intersection parameters")]
    [InlineData("Aabb", "Slab(B0.Y, B1.Y, P.Y, d.Y)", "Slab(B0.Y, B1.Y, P.Y, d.X)", "y0, on the way to t of box", "AABB checking for intersection")]
    [InlineData("Camera", "* ray.HitModel.Color", "* new Color(ray.HitModel.Color.B, ray.HitModel.Color.G, ray.HitModel.Color.R)",
        "red, green and blue of Shade", "Primitive Shading")]
    [InlineData("Camera", "ray.HitParameter / (2", "ray.HitParameter * ray.DepthPerT / (2", "attenuation", "Primitive Shading")]
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
        Assert.Equal("Your numbers of the steps 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 are right for this pixel. The tests of step 10 ask more.", lines[^1]);
        lines = Numbers("Vector3", "return new(a.X - b.X", "return Todo.Note(\"IDE & Vectors\", Zero); return new(a.X - b.X");
        Assert.Equal(["  a + b for a = (1, 2, 3), b = (4, −5, 6): not written yet. Step 1, slide \"IDE & Vectors\"",
            "No number is yours: what this pixel asks for is not written yet."], lines[1..]);
        lines = Numbers("Camera", "var attenuation =", "return Todo.Note(\"Primitive Shading\", ray.HitModel.Color); var attenuation =");
        AssertHas("  bytes: (255, 255, 0)", lines);
        Assert.Equal("Your numbers of the steps 1, 2, 3, 4, 6, 7, 8, 9, 10 are right for this pixel. The tests of step 10 ask more.", lines[^1]);
    }

    [Fact]
    public void BeforeThereIsACameraExamplesAreShown()
    {
        var lines = Numbers("Camera", "W = -(", "Todo.Note(\"Camera\"); W = (");
        AssertHas("  X(5) for P = (1, 2, 3), d = (0.48, 0.6, −0.64): (3.4, 5, −0.2)", lines);
        AssertHas("  HitParameter and HitModel after Hit(5), Hit(3), Hit(4): 3, that of call 2", lines);
        AssertHas("  t of a plane with Q = (3, 3, −1), n = (1, 2, −1) for P = (1, 2, 3), d = (0.48, 0.6, −0.64): 3.44828", lines);
        Assert.Equal("  W: not written yet. Step 4, slide \"Camera\"", lines[^2]);
        Assert.Equal("Your numbers of the steps 1, 2, 3, 6 are right for this pixel. The tests of step 6 ask more.", lines[^1]);
    }

    /// <summary>The right ones, and one's own where the calls of Hit and Slab tell them.</summary>
    [Theory]
    [InlineData("Sphere", "(R * R - D * D)", "(R - D * D)", "t_ca: 20.", "D²: right 2.", "t_hc: yours 1.")]
    [InlineData("Sphere", "ray.Hit(t_ca + t_hc", "ray.Hit(t_ca", "t_ca: right 20.", "t_hc: right 3.", "t_ca + t_hc: yours 20.")]
    [InlineData("Sphere", "CP * CP - R * R", "CP * CP - R", "b: right −", "c: right 416", "−b / (2a): 20.", "√(b² − 4ac) / (2a): yours ")]
    [InlineData("Aabb", "Slab(B0.X, B1.X, P.X, d.X)", "Slab(B0.X, B1.X, P.X, d.Y)", "x1: yours ", "y1: ", "z1: ")]
    [InlineData("Aabb", "Math.Min(x1, Math.Min", "Math.Max(x1, Math.Min", "t_min: ", "t_max: yours ")]
    [InlineData("Circle", "<= R", "<= R * R * R", "t: ", "|X − C|: right ")]
    [InlineData("Triangle", "u / sum >= 0 && ", "u / sum < 0 && ", "t: ", "u: right ", "v: right ", "u + v: right ")]
    public void BelowTheFirstWrongTAreTheNumbersOnTheWay(string file, string old, string @new, params string[] between)
    {
        var scene = room with { Models = [.. room.Models.Where(model => model.Kind == file.ToLowerInvariant())] };
        var (column, line) = file switch { "Sphere" => (325, 359), "Aabb" => (170, 330), "Circle" => (350, 190), _ => (150, 190) };
        var lines = EditedLab.PixelOf(scene, column, line, "answer", file, old, @new, null).Split('\n');
        var first = Array.FindIndex(lines, text => text.Contains("the first wrong value"));
        Assert.True(first >= 0, string.Join('\n', lines));
        var below = lines[(first + 1)..].TakeWhile(text => text.StartsWith("    ", StringComparison.Ordinal)).ToList();
        Assert.All(between, start => Assert.Contains(below, text => text.StartsWith("    " + start, StringComparison.Ordinal)));
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
