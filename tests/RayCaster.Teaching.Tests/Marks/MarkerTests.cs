using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Points for pictures that <see cref="EditedLab"/> draws.</summary>
public class MarkerTests
{
    internal static readonly Rubric whole = RubricReader.Read(ProjectFolder.PathOf("docs/rubric.json"), out _)!;

    /// <summary>The course's rubric with half of its scenes, which show all that is planted here, in pictures a quarter as large.</summary>
    internal static readonly Rubric rubric = With(whole.Items, ScenesOf("1-planes", "3-inside", "4-flat", "4-all").Select(Small));

    /// <summary>The same with the two that show the most.</summary>
    internal static readonly Rubric two = With(whole.Items, ScenesOf("3-inside", "4-all").Select(Small));

    internal static IEnumerable<MarkedScene> ScenesOf(params string[] names) => whole.Scenes.Where(scene => names.Contains(scene.Name));

    internal static Rubric With(IReadOnlyList<RubricItem> items, IEnumerable<MarkedScene> scenes) =>
        new([.. scenes])
        {
            Title = whole.Title,
            Hint = whole.Hint,
            Items = items,
            Pictures = whole.Pictures,
        };

    internal static MarkedScene Small(MarkedScene scene)
    {
        var camera = scene.Scene.Camera;
        return scene with { Judge = new(scene.Scene.WithSize(camera.Width / 2, camera.Height / 2)) };
    }

    internal static StudentMarks Mark(Func<Scene, Picture?> draw) => Mark(rubric, draw);

    internal static StudentMarks Mark(Rubric rubric, Func<Scene, Picture?> draw) => new Marker(rubric).Mark("somebody",
        [.. rubric.Scenes.Select(
            scene => draw(scene.Scene) is { } picture ? new SubmittedPicture(scene, picture, null) : new(scene, null, "no picture"))]);

    internal static StudentMarks Mark(string mistake, string second = "ok", string undone = "") => Mark(scene =>
        EditedLab.Render(Without(scene, undone), Manner.OfTheSlides, Planted.Named(mistake), Planted.Named(second)));

    internal static Scene Without(Scene scene, string kinds) =>
        scene with { Models = [.. scene.Models.Where(model => !kinds.Split(' ').Contains(model.Kind))] };

    internal static string[] Lost(StudentMarks marks) =>
        [.. marks.Items.Where(item => item.Points < item.Of).Select(item => item.Name.Split(' ')[0])];

    [Fact]
    public void ARightProgramGetsAllPoints()
    {
        var marks = Mark("ok");
        Assert.Equal((20.0, 0.0), (marks.Points, marks.Undecided));
        Assert.Empty(marks.LookYourself);
    }

    [Theory]
    [InlineData("Both", "ok", 12, "2")]
    [InlineData("Both", "ok", 9, "0 +2")]     // the two contradict each other
    [InlineData("Both", "r-nosq", 12, "0 +2")]
    [InlineData("Both", "r-nosq", 9, "0")]
    [InlineData("Tests", "r-nosq", 12, "2")]
    [InlineData("Tests", "ok", 9, "0")]
    [InlineData("Tests", "ok", 0, "0 +2")]    // they did not run
    [InlineData("Pictures", "ok", 9, "2")]
    public void PicturesAndTestsOfAStepDecideTogether(string evidence, string mistake, int passed, string expected)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = Enum.Parse<ItemEvidence>(evidence), Step = 8 };
        var both = With([item], ScenesOf("4-all").Select(Small));
        var scene = both.Scenes[0];
        var picture = EditedLab.Render(scene.Scene, Manner.OfTheSlides, Planted.Named(mistake), Planted.None);
        Dictionary<int, StepResult>? tests = passed == 0 ? null : new() { [8] = new(8, passed, 12) };
        var marks = new Marker(both).Mark("somebody", [new(scene, picture, null)], tests);
        Assert.Equal(expected, $"{marks.Points}{(marks.Undecided > 0 ? $" +{marks.Undecided}" : "")}");
        Assert.Equal(evidence == "Both" && expected == "0 +2" ? [$"8 Sphere: {passed} of 12 tests of step 8 pass, "
            + $"but its pictures {(mistake == "ok" ? "cost no points" : "cost points")}"] : Array.Empty<string>(), marks.LookYourself);
    }

    [Theory]
    [InlineData("Tests", 8, 1, 0.0, 2.0)] // rays and shapes use the vectors
    [InlineData("Both", 8, 1, 2.0, 0.0)]
    [InlineData("Tests", 8, 3, 0.0, 0.0)] // a sphere is no plane
    [InlineData("Tests", 5, 3, 0.0, 2.0)] // the light's tests look at a plane
    public void AStepThatFailsWithOneThatItUsesLosesNothing(string evidence, int step, int used, double points, double undecided)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = Enum.Parse<ItemEvidence>(evidence), Step = step };
        var both = With([item], ScenesOf("4-all").Select(Small));
        var tests = new Dictionary<int, StepResult> { [used] = new(used, 3, 4), [step] = new(step, 3, 4) };
        var marks = new Marker(both).Mark("somebody", [new(both.Scenes[0], both.Scenes[0].Right, null)], tests);
        Assert.Equal((points, undecided), (marks.Points, marks.Undecided));
    }

    [Theory]
    [InlineData("rad", "ok", "4")] // follow-through: all shapes are elsewhere, and only the camera costs
    public void AMistakeCostsItsOwnItemAndNoOther(string mistake, string second, string lost)
    {
        var marks = Mark(mistake, second);
        Assert.Equal((lost, 0.0), (string.Join(' ', Lost(marks)), marks.Undecided));
    }

    [Theory]
    [InlineData("Circle", "C - ray.Origin", "ray.Origin - C", "9")] // the sign is the plane's mistake, but planes are right
    public void ASlipInAShapesOwnFormulaCostsThatShape(string file, string old, string @new, string lost)
    {
        var slip = new Planted($"{file}: {@new}", "", new Edit(file, old, @new));
        var marks = Mark(With(whole.Items, ScenesOf("1-planes", "3-boxes", "4-flat").Select(Small)), scene => EditedLab.Render(scene, slip));
        Assert.Equal(lost, string.Join(' ', Lost(marks)));
    }

    [Theory]
    [InlineData("ok", "aabb circle sphere triangle", "7 8 9 10")]
    public void WhatIsNotDrawnYetCostsItsItems(string mistake, string undone, string lost)
    {
        var marks = Mark(mistake, undone: undone);
        Assert.Equal((lost, 0.0), (string.Join(' ', Lost(marks)), marks.Undecided));
        Assert.Equal(undone, string.Join(' ', marks.NotDrawn.Order()));
    }

    [Fact]
    public void AMistakeThatLosesAShapeIsNamedBesideTheMissingShape()
    {
        var marks = Mark(two, scene => EditedLab.Render(scene, Planted.Named("slab-noswap")));
        Assert.Equal(["aabb"], marks.NotDrawn);
        Assert.Contains("slab-noswap", marks.HidingMistakes);
        Assert.StartsWith("If they are written: ", MarkWords.Question("aabb", marks.HidingMistakes));
    }

    [Fact]
    public void APartThatOnlyAMissingPictureShowsIsUndecided()
    {
        var parts = With([new("Plane", 1, 1, [], ["plane"]), new("Sphere", 2, 2, [], ["sphere"])], rubric.Scenes);
        var marks = Mark(parts, scene => scene == rubric.Scenes[0].Scene ? ScalarRenderer.Render(scene) : null);
        Assert.Equal((1.0, 2.0), (marks.Points, marks.Undecided)); // no sphere is in the only picture
    }

    [Theory] // no known mistake explains these, but a small edit of one step's formulas does
    [InlineData("Camera", "(Up % W)", "(new Vector3(0, 0, 1) % W)", "4 Camera", "camera: normalize((0, 0, 1) × W) was written instead of")]
    public void WhatOneStepsFormulasExplainLeavesOnlyItsItemUndecided(string file, string old, string @new, string item, string says)
    {
        var slip = new Planted($"{file}: {@new}", "", new Edit(file, old, @new));
        var marks = Mark(With(whole.Items, ScenesOf("3-spheres", "4-all").Select(Small)), scene => EditedLab.Render(scene, slip));
        Assert.Equal([item], marks.Items.Where(item => item.Undecided > 0).Select(item => item.Name));
        Assert.Equal([], marks.Items.Where(item => item.Points + item.Undecided < item.Of));
        Assert.Contains(says, Assert.Single(marks.LookYourself));
        Assert.Empty(marks.Mistakes);
    }

    [Fact] // a camera that looks backwards sees no sphere, so spheres may be unwritten
    public void AShapeThatAMistakeKeepsOutOfAllPicturesIsUndecided()
    {
        var walls = Small(ScenesOf("1-planes").Single());
        var ball = Model.Of(new Sphere(walls.Scene.Camera.Target, 1));
        var room = walls with { Judge = new(walls.Scene with { Models = [.. walls.Scene.Models, ball] }) };
        var marks = Mark(With(whole.Items, [room]), scene => EditedLab.Render(scene, Planted.Named("w-sign")));
        Assert.Equal("4", string.Join(' ', Lost(marks).Except(["8"])));
        Assert.Equal(2, marks.Items[7].Undecided);
    }

    [Fact]
    public void TheUntouchedHandOutGetsNoPointsAndIsNotUndecided()
    {
        var marks = Mark(scene =>
        {
            var (picture, camera) = (new Picture(scene.Camera.Width, scene.Camera.Height), scene.Camera);
            for (var r = 0; r < camera.Height; r++) // the stub of Scene.CastRay
                for (var c = 0; c < camera.Width; c++)
                    picture[c, camera.Height - 1 - r] = new Color((double)c / camera.Width, (double)r / camera.Height, 0.5).ToBytes();
            return picture;
        });
        Assert.Equal((0.0, 0.0), (marks.Points, marks.Undecided));
        Assert.Single(marks.LookYourself);
    }

    [Fact]
    public void PicturesOfOneColourTellNothing()
    {
        var marks = Mark(scene => new Picture(scene.Camera.Width, scene.Camera.Height));
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.Equal("all pictures are of one colour: many mistakes cause that", Assert.Single(marks.LookYourself));
    }
}
