
namespace RayCaster.Teaching.Tests.Explanations;

/// <summary>The explanation of a pixel is the pixel's: the same hit, the same bytes, and each number follows from those before it.</summary>
public class PixelExplanationTests
{
    public static TheoryData<string> Scenes => [.. SceneFolder.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void TheNumbersReadBackGiveThePicturesBytes(string name) =>
        CheckAgainstPicture(SceneFolder.Read(SceneFolder.FileOf(name)).WithSize(60, 40), new Random(3), 12);

    [Fact]
    public void TheNumbersReadBackGiveTheBytesOfRandomScenes()
    {
        var random = new Random(11);
        for (var i = 0; i < 60; i++) CheckAgainstPicture(RandomScene.Make(random), random, 4);
    }

    [Theory]
    [InlineData(-10, 0, Outcome.Behind, "t = −10 < 0: behind the camera")]
    [InlineData(1e-7, 0, Outcome.UnderBias, "t = 1e-7 ≤ bias = 1e-6: too near to where the ray starts")]
    [InlineData(2.1, 3, Outcome.BeforeNear, "z = 2.1 < zNear = 3: clipped away, nearer than the near plane")]
    [InlineData(120, 0, Outcome.BeyondFar, "z = 120 > zFar = 100: clipped away, beyond the far plane")]
    public void ARefusedCrossingSaysWhy(double distance, double zNear, Outcome outcome, string reason)
    {
        var model = Explain(Model.Of(new Plane(new(-distance, 0, 0), new(1, 0, 0))), zNear);
        Assert.Equal((outcome, reason), (model.Result.Outcome, model.Reason));
        Assert.Equal(outcome, Assert.Single(model.Crossings).Outcome);
    }

    public static TheoryData<Model, string> Missed => new()
    {
        { Model.Of(new Plane(new(0, 0, -1), new(0, 0, 1))), "d·n = 0: the ray runs along the plane" },
        { Model.Of(new Sphere(new(-5, 2.5, 0), 2)), "|D| = 2.5 > R = 2: the ray misses the sphere" },
        { Model.Of(new Circle(new(-5, 2.3, 0), new(1, 0, 0), 2)), "|X − C| = 2.3 > R = 2: outside the circle" },
    };

    [Theory]
    [MemberData(nameof(Missed))]
    public void AShapeThatIsMissedSaysWhy(Model model, string reason) => Assert.Equal(reason, Explain(model).Reason);

    [Fact]
    public void ATriangleTellsWhichOfItsNumbersFails()
    {
        var model = Explain(Model.Of(new Triangle(new(-5, -1, -1), new(-5, 0.25, -1), new(-5, -1, 0.25))));
        Assert.Equal("u + v = 1.6 > 1: outside the triangle", model.Reason);
        Assert.Equal([-0.6, 0.8, 0.8], model.Weights!.Select(weight => Math.Round(weight, 12)));
        Assert.Equal(5, model.Crossings[0].Untested!.Value, 12);
    }

    [Fact]
    public void ABoxTellsWhichSlabsDoNotMeet()
    {
        var model = Explain(Model.Of(new Aabb(new(-6, 1, -1), new(-5, 2, 1))));
        Assert.Equal("t_min = ∞ > t_max = 6: it leaves the x slab before it enters the y slab", model.Reason);
        Assert.Equal("xyz", string.Concat(model.Slabs.Select(slab => slab.Axis)));
        Assert.Equal((5, 6), (model.Slabs[0].Enters, model.Slabs[0].Leaves));
    }

    [Fact]
    public void AShapeOfOnesOwnIsExplainedByItsOwnFormula()
    {
        var model = Explain(Model.Of(new Ring(new(-5, 0.5, 0), new(1, 0, 0), 1, 2)));
        Assert.Equal(("ring", Outcome.Misses), (model.Result.Model.Kind, model.Result.Outcome));
        Assert.EndsWith("= 0.25 ≥ 1 is false", model.Reason);
        Assert.Equal("t", Assert.Single(model.Steps).Name);
        Assert.Equal(5, model.Crossings[0].Untested);
    }

    [Fact]
    public void AModelInPlainDoublesTellsItsTAndWhereItWouldBeHitUnclipped()
    {
        var seen = Explain(new Cylinder(new(-5, 0, 0), 1, 4));
        Assert.Equal((Outcome.Shows, 4.0), (seen.Result.Outcome, Assert.Single(seen.Crossings).T));
        var clipped = Explain(new Cylinder(new(-5, 0, 0), 1, 4), zNear: 20);
        Assert.Equal((Outcome.BeforeNear, 4.0), (clipped.Result.Outcome, Assert.Single(clipped.Crossings).T));
        Assert.StartsWith("z = 4 < zNear = 20", clipped.Reason);
        Assert.EndsWith("< 0: behind the camera", Explain(new Cylinder(new(5, 0, 0), 1, 4)).Reason);
    }

    [Fact]
    public void AMeshTellsWhichTriangleIsHit()
    {
        var mesh = new Mesh([new(-5, -9, -9), new(-5, 9, -9), new(-5, 0, 9), new(-4, 20, 20), new(-4, 21, 20), new(-4, 20, 21), new(3, -9, -9),
            new(3, 9, -9), new(3, 0, 9)],
            [3, 4, 5, 6, 7, 8, 0, 1, 2]);
        var model = Explain(mesh);
        Assert.Equal(2, model.Result.Triangle);
        Assert.Equal(5, model.Crossings[0].T, 12);
    }

    [Fact]
    public void OfTwoEqualHitsTheFirstInTheSceneShows()
    {
        var plane = new Plane(new(-5, 0, 0), new(1, 0, 0));
        var pixel = new PixelExplanation(Scene([Model.Of(plane), Model.Of(plane)]), 0, 0);
        Assert.Equal(0, pixel.Winner);
        Assert.Contains("a tie", pixel.Models[1].Reason);
        Assert.Contains(pixel.Notes, note => note.StartsWith("a tie:"));
    }

    [Fact]
    public void ARayInAFaceOfABoxIsNoted() =>
        Assert.Contains("0 / 0", Assert.Single(new PixelExplanation(Scene([Model.Of(new Aabb(new(-6, 0, -1), new(-5, 2, 1)))]), 0, 0).Notes));

    [Fact]
    public void LostLightAndClampedColoursAreNoted()
    {
        var far = new PixelExplanation(Scene([Model.Of(new Plane(new(-50, 0, 0), new(1, 0, 0)))]), 0, 0);
        Assert.Contains(far.Notes, note => note == "all light is lost: t = 50 ≥ 2 |T − P| = 40, so the attenuation is 0");
        var bright = Model.Of(new Plane(new(-4, 0, 0), new(1, 0, 0)));
        bright.Color = new(2, 0, 0);
        Assert.Contains(new PixelExplanation(Scene([bright]), 0, 0).Notes, note => note.Contains("clamped: the colour is (1.8, 0, 0)"));
    }

    [Fact]
    public void OfManyModelsTheWinnerAndTheNearMissesAreExplainedAndTheRestCounted()
    {
        var models = new List<Model>();
        for (var i = 0; i < 40; i++) models.Add(Model.Of(new Sphere(new(-30 + i, 0, 0), 0.4)));
        for (var i = 0; i < 40; i++) models.Add(Model.Of(new Sphere(new(-30, 30 + i, 0), 0.4)));
        var pixel = new PixelExplanation(Scene(models), 0, 0);
        Assert.Equal(30, pixel.Winner); // the camera is in it
        Assert.Equal([27, 28, 29, 30, 31, 32, 33], pixel.Models.Select(model => model.Result.Index));
        Assert.Equal((73, 27, 6, 40),
            (pixel.Others.Total, pixel.Others[Outcome.Hidden], pixel.Others[Outcome.Behind], pixel.Others[Outcome.Misses]));
    }

    [Fact]
    public void ThePixelsBesideAnOutlineAreNamed()
    {
        var ball = Model.Of(new Sphere(new(-5, 0, 0), 1));
        ball.Name = "ball";
        var scene = new Scene(new Camera(new(0, 0, 0), new(-20, 0, 0)) { Width = 40, Height = 40 }, [ball]);
        var picture = ScalarRenderer.Render(scene);
        var column = Enumerable.Range(0, 40).First(x => picture[x + 1, 20] != (0, 0, 0));
        var pixel = new PixelExplanation(scene, column, 20);
        Assert.Equal("right", pixel.Models[0].Beside);
        Assert.Contains(pixel.Notes, note => note == $"an outline: the pixel to the right (column {column + 1}, line 20) shows ball");
    }

    [Fact]
    public void AReferenceThatShowsAHiddenModelIsRecognised()
    {
        var (near, far) = (Model.Of(new Plane(new(-5, 0, 0), new(1, 0, 0))), Model.Of(new Plane(new(-10, 0, 0), new(1, 0, 0))));
        (near.Name, near.Color, far.Name, far.Color) = ("ball", new(1, 0, 0), "wall", new(0, 1, 0));
        var scene = Scene([near, far]);
        var explanation = ReferenceExplanation.Create(new PixelExplanation(scene, 0, 0), ScalarRenderer.Render(scene with { Models = [far] }));
        Assert.False(explanation.Agrees);
        Assert.Equal((-223, 191, 0), explanation.Difference);
        Assert.Equal("the other picture's colour is what wall would give: its crossing at t = 10 is hidden by ball, whose t = 5 < 10",
            Assert.Single(explanation.Causes));
    }

    [Fact]
    public void AReferenceThatAgreesNeedsNoCause()
    {
        var scene = Scene([Model.Of(new Plane(new(-5, 0, 0), new(1, 0, 0)))]);
        var picture = ScalarRenderer.Render(scene);
        picture[0, 0] = ((byte)(picture[0, 0].R - 1), picture[0, 0].G, picture[0, 0].B);
        var explanation = ReferenceExplanation.Create(new PixelExplanation(scene, 0, 0), picture);
        Assert.True(explanation.Agrees);
        Assert.Empty(explanation.Causes);
    }

    [Fact]
    public void APixelOutsideOfThePictureIsRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new PixelExplanation(Scene([]), 1, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PixelExplanation(Scene([]), 0, -1));
    }

    /// <summary>An explanation as people read it; <c>dotnet run --project tests/Tools/Generator</c> writes it again.</summary>
    internal static string TextFile => ProjectFolder.PathOf("tests/RayCaster.Teaching.Tests/Explanations/room.txt");

    internal static string Text() =>
        ExplanationText.Format(new PixelExplanation(SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!, 250, 380));

    [Fact]
    public void TheTextForPeopleStaysAsItIs() => Assert.Equal(File.ReadAllText(TextFile).ReplaceLineEndings("\n"), Text());

    private static void CheckAgainstPicture(Scene scene, Random random, int pixels)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        new Renderer(scene, 1).DrawInto(picture);
        for (var i = 0; i < pixels; i++)
        {
            var (column, line) = (random.Next(picture.Width), random.Next(picture.Height));
            var pixel = new PixelExplanation(scene, column, line);
            Assert.Equal(picture[column, line], pixel.Bytes);
            Assert.NotEmpty(ExplanationText.Format(pixel));
            CheckNumbers(pixel, picture[column, line]);
        }
    }

    /// <summary>Follows the numbers of the explanation alone to the bytes.</summary>
    private static void CheckNumbers(PixelExplanation pixel, (byte R, byte G, byte B) bytes)
    {
        var full = pixel.Scene.Background;
        var light = 1.0;
        if (pixel.Winner is { } index)
        {
            var t = pixel.Hit.T;
            full = pixel.Scene.Models[index].Color;
            light = Math.Max(0, 1 - t / pixel.Scene.Camera.FadeDistance);
            Assert.Equal(light, pixel.ColorSteps.Single(step => step.Name == "attenuation").Value);
            var winner = pixel.Models.Single(model => model.Result.Outcome == Outcome.Shows);
            var shown = winner.Crossings.Single(crossing => crossing.Outcome == Outcome.Shows);
            Assert.Equal(index, winner.Result.Index);
            Assert.Equal(t, shown.T);
            Assert.Equal(t * pixel.Ray.DepthPerT, shown.Z);
        }
        Assert.Equal(pixel.Color, light * full);
        Assert.Equal(bytes, (Level(pixel.Color.R), Level(pixel.Color.G), Level(pixel.Color.B)));

        static byte Level(double channel) => (byte)(255 * Math.Clamp(channel, 0, 1) + 0.5);
    }

    /// <summary>One pixel, whose ray goes along −x from the origin.</summary>
    private static Scene Scene(IReadOnlyList<Model> models, double zNear = 0) =>
        new(new Camera(new(0, 0, 0), new(-20, 0, 0)) { Width = 1, Height = 1, ZNear = zNear, Sample = PixelSample.Center }, models);

    private static ModelExplanation Explain(Model model, double zNear = 0) => new PixelExplanation(Scene([model], zNear), 0, 0).Models[0];
}
