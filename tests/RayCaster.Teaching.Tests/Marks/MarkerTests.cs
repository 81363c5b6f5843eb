using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Points for pictures that <see cref="EditedLab"/> draws.</summary>
public class MarkerTests
{
    private static readonly Rubric whole = RubricReader.Read(ProjectFolder.PathOf("docs/rubric.json"), out _)!;

    /// <summary>The course's rubric with half of its scenes, which show all that is planted here, in pictures a quarter as large.</summary>
    private static readonly Rubric rubric = With(whole.Items, Scenes("1-planes", "3-inside", "4-flat", "4-all").Select(Small));

    /// <summary>The same with the two that show the most.</summary>
    private static readonly Rubric two = With(whole.Items, Scenes("3-inside", "4-all").Select(Small));

    private static IEnumerable<MarkedScene> Scenes(params string[] names) => whole.Scenes.Where(scene => names.Contains(scene.Name));

    private static Rubric With(IReadOnlyList<RubricItem> items, IEnumerable<MarkedScene> scenes) =>
        new([.. scenes], "")
        {
            Title = whole.Title,
            Path = whole.Path,
            Hint = whole.Hint,
            Items = items,
            Source = whole.Source,
        };

    private static MarkedScene Small(MarkedScene scene)
    {
        var camera = scene.Scene.Camera;
        return scene with { Judge = new(scene.Scene.WithSize(camera.Width / 2, camera.Height / 2)) };
    }

    private static StudentMarks Mark(Func<Scene, Picture?> draw) => Mark(rubric, draw);

    private static StudentMarks Mark(Rubric rubric, Func<Scene, Picture?> draw) => new Marker(rubric).Mark("somebody",
        [.. rubric.Scenes.Select(
            scene => draw(scene.Scene) is { } picture ? new SubmittedPicture(scene, picture, null) : new(scene, null, "no picture"))]);

    private static StudentMarks Mark(string mistake, string second = "ok", string undone = "") => Mark(scene =>
        EditedLab.Render(Without(scene, undone), Manner.OfTheSlides, Planted.Named(mistake), Planted.Named(second)));

    private static Scene Without(Scene scene, string kinds) =>
        scene with { Models = [.. scene.Models.Where(model => !kinds.Split(' ').Contains(model.Kind))] };

    private static string[] Lost(StudentMarks marks) =>
        [.. marks.Items.Where(item => item.Points < item.Of).Select(item => item.Name.Split(' ')[0])];

    [Fact]
    public void ARightProgramGetsAllPoints()
    {
        var marks = Mark("ok");
        Assert.Equal((20.0, 0.0), (marks.Points, marks.Undecided));
        Assert.Empty(marks.LookYourself);
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
        var marks = Mark(With(whole.Items, Scenes("1-planes", "3-boxes", "4-flat").Select(Small)), scene => EditedLab.Render(scene, slip));
        Assert.Equal(lost, string.Join(' ', Lost(marks)));
    }

    [Theory]
    [Trait("kind", "campaign")]
    [InlineData("Aabb", "P <= B1", "P <= B0", "7")] // a ray along a slab misses it
    public void AnotherSlipInAShapesOwnFormulaCostsThatShape(string file, string old, string @new, string lost) =>
        ASlipInAShapesOwnFormulaCostsThatShape(file, old, @new, lost);

    /// <remarks>Beside a box's mistake, one of the vectors explained a hundredth of the pixels of one scene, and was charged.</remarks>
    [Theory]
    [Trait("kind", "campaign")] // all pairs of mistakes are tried
    [InlineData("Slab(B0.X, B1.X, P.X, d.X)")]
    [InlineData("Slab(B0.X, B1.X, P.Y, d.Y)")]
    [InlineData("Slab(B0.Y, B1.Y, P.X, d.X)")]
    public void AMistakeThatExplainsAFewPixelsBesideAnotherIsNotCharged(string slab)
    {
        var slip = new Planted("the y slab with the box's x", "", new Edit("Aabb", "Slab(B0.Y, B1.Y, P.Y, d.Y)", slab));
        var marks = Mark(whole, scene => EditedLab.Render(scene, slip));
        Assert.Empty(marks.Items.Where(item => item.Points + item.Undecided < item.Of && item.Name != "7 AABB").Select(item => item.Name));
    }

    [Fact]
    [Trait("kind", "campaign")] // all pairs of mistakes are tried
    public void AFewWrongPixelsThatNothingExplainsLeaveTheirItemUndecided()
    {
        var slip = new Planted("never along a slab", "", new Edit("Aabb", "B0 <= P", "B0 >= P"));
        var marks = Mark(With(whole.Items, Scenes("1-planes", "3-boxes", "3-spheres", "4-all")), scene => EditedLab.Render(scene, slip));
        Assert.Empty(Lost(marks).Except(["7"]));
        Assert.Equal(["7 AABB"], marks.Items.Where(item => item.Undecided > 0).Select(item => item.Name));
    }

    [Theory] // each of the two changes a whole picture, so neither is near by itself
    [InlineData("rows", "nohalf", "4")]
    public void TwoMistakesThatChangeWholePicturesCostTheirItems(string mistake, string second, string lost)
    {
        var marks = Mark(two, scene => EditedLab.Render(scene, Manner.OfTheSlides, Planted.Named(mistake), Planted.Named(second)));
        Assert.Equal((lost, 0.0), (string.Join(' ', Lost(marks)), marks.Undecided));
    }

    [Theory]
    [Trait("kind", "campaign")] // more of the same
    [InlineData("v-cross", "att-depth", "4 5")]
    [InlineData("u-cross", "nohalf", "4")]
    [InlineData("no2", "att-none", "4 5")]
    public void OtherMistakesThatChangeWholePicturesCostTheirItems(string mistake, string second, string lost) =>
        TwoMistakesThatChangeWholePicturesCostTheirItems(mistake, second, lost);

    [Theory]
    [Trait("kind", "campaign")] // more of the same
    [InlineData("near-root-only", "ok", "8")] // shows in one scene only
    [InlineData("r-nosq", "ok", "8")]
    [InlineData("att-no2", "plane-cull", "3 5")]
    [InlineData("aspect-inv", "circ-nosq", "4 9")]
    public void OtherMistakesCostTheirOwnItems(string mistake, string second, string lost) =>
        AMistakeCostsItsOwnItemAndNoOther(mistake, second, lost);

    [Theory]
    [InlineData("ok", "circle triangle", "9 10")]
    [InlineData("ok", "aabb circle sphere triangle", "7 8 9 10")]
    [InlineData("u-cross", "circle sphere triangle", "4 8 9 10")]
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
        Assert.Contains("slab-noswap", marks.Losing);
        Assert.StartsWith("If they are written: ", MarkWords.Question("aabb", marks.Losing));
    }

    [Fact]
    [Trait("kind", "campaign")] // tries all pairs of mistakes
    public void AFaultOfMostPicturesThatNothingExplainsMayBeInTheVectors()
    {
        var slip = new Planted("a wrong letter in the scalar product", "", new Edit("Vector3", "a.Z * b.Z;", "a.Z * a.Z;"));
        var marks = Mark(scene => EditedLab.Render(scene, slip));
        Assert.Contains("1 Vectors", marks.Items.Where(item => item.Undecided > 0).Select(item => item.Name));
    }

    [Fact]
    [Trait("kind", "campaign")] // tries all pairs of mistakes
    public void WhatNothingExplainsIsUndecidedAndFlaggedAndNotLost()
    {
        var random = new Random(1);
        var marks = Mark(two, scene =>
        {
            var noise = new Picture(scene.Camera.Width, scene.Camera.Height);
            random.NextBytes(noise.Rgb);
            return noise;
        });
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.Empty(marks.Mistakes);
        Assert.Equal("3-inside, 4-all: no known mistake explains this", Assert.Single(marks.LookYourself));
    }

    [Fact]
    [Trait("kind", "campaign")] // tries all pairs of mistakes
    public void WhereAllOutlinesAreRightOnlyTheLightIsUndecided()
    {
        var marks = Mark(two, scene =>
        {
            var picture = ScalarRenderer.Render(scene);
            for (var i = 0; i < picture.Rgb.Length; i++) picture.Rgb[i] /= 2;
            return picture;
        });
        Assert.Equal((18.0, "5"), (marks.Points, string.Join(' ', Lost(marks))));
        Assert.Contains("all outlines are right, only the light is not", Assert.Single(marks.LookYourself));
    }

    [Fact]
    [Trait("kind", "campaign")] // more of the same
    public void WhereTheLightOfOneKindOfShapeIsWrongItsItemIsUndecided()
    {
        var spheres = With(whole.Items, Scenes("3-spheres", "4-all").Select(Small));
        var marks = new Marker(spheres).Mark(
            "somebody", [.. spheres.Scenes.Select(scene => new SubmittedPicture(scene, Darkened(scene), null))]);
        Assert.Contains("8", Lost(marks));

        static Picture Darkened(MarkedScene scene)
        {
            var (picture, models) = (ScalarRenderer.Render(scene.Scene), new Renderer(scene.Scene).CastHits().Model);
            for (var i = 0; i < picture.Rgb.Length; i++)
                if (models[i / 3] is >= 0 and var model && scene.Scene.Models[model].Kind == "sphere") picture.Rgb[i] = (byte)(picture.Rgb[i] * 0.7);
            return picture;
        }
    }

    [Fact]
    public void WherePicturesAreMissingOnlyWhatTheOthersTellIsGiven()
    {
        var marks = Mark(scene => scene == rubric.Scenes[0].Scene ? ScalarRenderer.Render(scene) : null);
        Assert.Equal((0.0, 2.0), (marks.Items[7].Points, marks.Items[7].Undecided)); // no sphere is in the only picture
        Assert.Equal((2.0, 0.0), (marks.Items[2].Points, marks.Items[2].Undecided)); // planes are
        Assert.Single(marks.LookYourself);
    }

    [Fact]
    public void APartThatOnlyAMissingPictureShowsIsUndecided()
    {
        var parts = With([new("Plane", 1, 1, [], ["plane"]), new("Sphere", 2, 2, [], ["sphere"])], rubric.Scenes);
        var marks = Mark(parts, scene => scene == rubric.Scenes[0].Scene ? ScalarRenderer.Render(scene) : null);
        Assert.Equal((1.0, 2.0), (marks.Points, marks.Undecided)); // no sphere is in the only picture
    }

    [Fact]
    public void PicturesOfOneColourTellNothing()
    {
        var marks = Mark(scene => new Picture(scene.Camera.Width, scene.Camera.Height));
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.Equal("all pictures are of one colour: many mistakes cause that", Assert.Single(marks.LookYourself));
    }
}
