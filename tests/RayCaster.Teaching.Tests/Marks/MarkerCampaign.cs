using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Marks.MarkerTests;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Points for pictures that <see cref="EditedLab"/> draws.</summary>
public class MarkerCampaign
{
    [Theory(Explicit = true)]
    [InlineData("Aabb", "P <= B1", "P <= B0", "7")] // a ray along a slab misses it
    public void AnotherSlipInAShapesOwnFormulaCostsThatShape(string file, string old, string @new, string lost) =>
        new MarkerTests().ASlipInAShapesOwnFormulaCostsThatShape(file, old, @new, lost);

    [Theory(Explicit = true)]
    [InlineData("Vector3", "a.Z + b.Z);", "a.Z - b.Z);", "1 Vectors", "vectors: a.z − b.z was written instead of a.z + b.z")]
    [InlineData("Scene", "? Background :", "? new Color(0, 0, 0) :", "5 Shading", "only the background is wrong")]
    public void WhatAnotherStepsFormulasExplainLeavesOnlyItsItemUndecided(string file, string old, string @new, string item, string says) =>
        new MarkerTests().WhatOneStepsFormulasExplainLeavesOnlyItsItemUndecided(file, old, @new, item, says);

    /// <remarks>Beside a box's mistake, one of the vectors explained a hundredth of the pixels of one scene, and was charged.</remarks>
    [Theory(Explicit = true)]
    [InlineData("Slab(B0.X, B1.X, P.X, d.X)")]
    [InlineData("Slab(B0.X, B1.X, P.Y, d.Y)")]
    [InlineData("Slab(B0.Y, B1.Y, P.X, d.X)")]
    public void AMistakeThatExplainsAFewPixelsBesideAnotherIsNotCharged(string slab)
    {
        var slip = new Planted("the y slab with the box's x", "", new Edit("Aabb", "Slab(B0.Y, B1.Y, P.Y, d.Y)", slab));
        var marks = Mark(whole, scene => EditedLab.Render(scene, slip));
        Assert.Empty(marks.Items.Where(item => item.Points + item.Undecided < item.Of && item.Name != "7 AABB").Select(item => item.Name));
    }

    [Fact(Explicit = true)]
    public void AFewWrongPixelsThatNothingExplainsLeaveTheirItemUndecided()
    {
        var slip = new Planted("never along a slab", "", new Edit("Aabb", "B0 <= P", "B0 >= P"));
        var marks = Mark(With(whole.Items, ScenesOf("1-planes", "3-boxes", "3-spheres", "4-all")), scene => EditedLab.Render(scene, slip));
        Assert.Empty(Lost(marks).Except(["7"]));
        Assert.Equal(["7 AABB"], marks.Items.Where(item => item.Undecided > 0).Select(item => item.Name));
    }

    [Theory(Explicit = true)]
    [InlineData("near-root-only", "ok", "8")] // shows in one scene only
    [InlineData("r-nosq", "ok", "8")]
    [InlineData("att-no2", "plane-cull", "3 5")]
    [InlineData("aspect-inv", "circ-nosq", "4 9")]
    public void OtherMistakesCostTheirOwnItems(string mistake, string second, string lost) =>
        new MarkerTests().AMistakeCostsItsOwnItemAndNoOther(mistake, second, lost);

    [Fact(Explicit = true)]
    public void AFaultOfMostPicturesThatNothingExplainsMayBeInTheVectors()
    {
        var slip = new Planted("a wrong letter in the scalar product", "", new Edit("Vector3", "a.Z * b.Z;", "a.Z * a.Z;"));
        var marks = Mark(scene => EditedLab.Render(scene, slip));
        Assert.Contains("1 Vectors", marks.Items.Where(item => item.Undecided > 0).Select(item => item.Name));
    }

    [Fact(Explicit = true)]
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

    [Theory(Explicit = true)]
    [InlineData(false, "a slip in")]
    [InlineData(true, "all outlines are right, only the light is not")]
    public void WhereAllOutlinesAreRightOnlyTheLightIsUndecided(bool isCurved, string expected)
    {
        var marks = Mark(two, scene =>
        {
            var picture = ScalarRenderer.Render(scene);
            for (var i = 0; i < picture.Rgb.Length; i += 3)
            {
                var pixel = picture.Rgb.AsSpan(i, 3);
                var light = isCurved ? 0.6 - 0.0004 * (pixel[0] + pixel[1] + pixel[2]) : 0.5;
                foreach (ref var level in pixel) level = (byte)(light * level);
            }
            return picture;
        });
        Assert.Equal((18.0, "5"), (marks.Points, string.Join(' ', Lost(marks))));
        Assert.Contains(expected, Assert.Single(marks.LookYourself));
    }

    [Fact(Explicit = true)]
    public void WhereTheLightOfOneKindOfShapeIsWrongItsItemIsUndecided()
    {
        var spheres = With(whole.Items, ScenesOf("3-spheres", "4-all").Select(Small));
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

    [Theory(Explicit = true)] // each of the two changes a whole picture, so neither is near by itself
    [InlineData("rows", "nohalf", "4")]
    [InlineData("v-cross", "att-depth", "4 5")]
    [InlineData("u-cross", "nohalf", "4")]
    [InlineData("no2", "att-none", "4 5")]
    public void TwoMistakesThatChangeWholePicturesCostTheirItems(string mistake, string second, string lost)
    {
        var marks = Mark(two, scene => EditedLab.Render(scene, Manner.OfTheSlides, Planted.Named(mistake), Planted.Named(second)));
        Assert.Equal((lost, 0.0), (string.Join(' ', Lost(marks)), marks.Undecided));
    }

    [Theory(Explicit = true)]
    [InlineData(12, 0.0, 2.0)]
    [InlineData(9, 0.0, 0.0)]
    public void TestsThatAllPassDoNotDecideWhatNoMistakeExplains(int passed, double points, double undecided)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = ItemEvidence.Both, Step = 8 };
        var both = With([item], ScenesOf("4-all").Select(Small));
        var right = both.Scenes[0].Right;
        var foreign = new Picture(right.Width, right.Height);
        for (var i = 0; i < right.Count; i++) foreign[i % right.Width, i / right.Width] = ((byte)(37 * i), (byte)(i / 91), (byte)(i * i / 13));
        var marks = new Marker(both).Mark("somebody", [new(both.Scenes[0], foreign, null)],
            new Dictionary<int, StepResult> { [8] = new(8, passed, 12) });
        Assert.Equal((points, undecided), (marks.Points, marks.Undecided));
    }

    [Fact(Explicit = true)]
    public void WherePicturesAreMissingOnlyWhatTheOthersTellIsGiven()
    {
        var marks = Mark(scene => scene == rubric.Scenes[0].Scene ? ScalarRenderer.Render(scene) : null);
        Assert.Equal((0.0, 2.0), (marks.Items[7].Points, marks.Items[7].Undecided)); // no sphere is in the only picture
        Assert.Equal((2.0, 0.0), (marks.Items[2].Points, marks.Items[2].Undecided)); // planes are
        Assert.Single(marks.LookYourself);
    }

    [Theory(Explicit = true)]
    [InlineData("ok", "circle triangle", "9 10")]
    [InlineData("u-cross", "circle sphere triangle", "4 8 9 10")]
    public void WhatElseIsNotDrawnYetCostsItsItems(string mistake, string undone, string lost) =>
        new MarkerTests().WhatIsNotDrawnYetCostsItsItems(mistake, undone, lost);
}
