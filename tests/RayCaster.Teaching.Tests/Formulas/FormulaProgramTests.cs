namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>What a program draws: the definition's picture, and with mistakes what they say, one on top of the other.</summary>
public class FormulaProgramTests
{
    private static readonly Scene generic = SceneFolder.Small("mistakes/generic", 4);

    /// <summary>A name that no step computes would be no value at all.</summary>
    /// <param name="step">1 for all edits, 8 for each eighth.</param>
    [Theory]
    [InlineData(8)]
    [InlineData(1, Explicit = true)]
    public void AnEditReadsOnlyWhatAProgramComputes(int step)
    {
        var slides = FormulaProgram.Slides;
        var evaluator = new FormulaEvaluator(generic, [(1, 2), (30, 20), (70, 40)], slides);
        foreach (var edit in Enum.GetValues<StepKind>().SelectMany(FormulaBook.Slides.StylesOf).SelectMany(MutationFactory.MutationsOf)
            .Where((_, i) => i % step == 0)) Assert.Null(Record.Exception(() => evaluator.Draw(ChangeSource.From(edit).In(slides)!)));
    }

    [Theory]
    [InlineData("u-cross")] // of all rays
    [InlineData("slab-minmin")] // of a shape
    [InlineData("no-znear")]
    [InlineData("last-hit")]
    [InlineData("disc-nan")]
    [InlineData("row-off")]
    [InlineData("att-no2")]
    [InlineData("crlf")]
    public void WhatDiffersFromTheSlidesIsDrawnAsTheWholeIs(string id)
    {
        foreach (var variant in MistakeCatalog.Named(id)!.Changes)
        {
            var slides = FormulaProgram.Slides;
            var program = variant.In(slides)!;
            (int X, int Y)[] pixels = [.. Enumerable.Range(0, 61).Select(i => (i * 7 % generic.Camera.Width, i * 5 % generic.Camera.Height))];
            var whole = program.Draw(generic);
            byte[] expected = [.. pixels.SelectMany<(int X, int Y), byte>(pixel => whole[pixel.X, pixel.Y] is var (r, g, b) ? [r, g, b] : [])];
            Assert.Equal(expected, FormulaEvaluator.Draw(generic, program, pixels));
            if (program.ByteShift == 0) Assert.Equal(expected, new FormulaEvaluator(generic, pixels, slides).Draw(program));
        }
    }

    [Fact]
    public void MistakesAddUp()
    {
        var both = Draw(generic, "rows", "bgr");
        var right = Draw(generic);
        var turned = Picture.Create(both.Width, both.Height, (x, y) => right[x, both.Height - 1 - y] is var (r, g, b) ? (b, g, r) : default);
        Assert.Equal(turned.Rgb, both.Rgb);
    }

    [Theory]
    [InlineData("t_hc = √(R - D2)", "t_hc = √(R² - √D2)", "t_hc = √(R − √D2)")] // two parts of a formula
    [InlineData("t_hc = √(R - D2)", "L = P - C", "t_hc = √(R − D2)")]
    [InlineData("t_hc = √(R - D2)", "t_hc = √(2·R - D2)", null)] // the same part
    public void TwoEditsOfAFormulaAreOneProgramIfTheyAreInDifferentParts(string one, string other, string? formula)
    {
        var program = Hypothesis.Create(ProgramInWords.Written($"sphere {one}"), ProgramInWords.Written($"sphere {other}"))?.Program;
        Assert.Equal(formula, program?[StepKind.Sphere].Formulas[3].ToString());
    }

    [Fact]
    public void TwoMistakesInOnePartOfAFormulaAreNoProgram() =>
        Assert.Throws<ArgumentException>(() => Draw(generic, "rows", "row-off"));

    [Fact]
    public void AMeshIsHitAsItsTrianglesAre()
    {
        var ball = MeshGenerator.Icosphere(1);
        var scene = new Scene(new(new(3, 1, 1), Vector3.Zero) { Width = 60, Height = 40 },
            [new Mesh(ball.Vertices, ball.Indices) { Color = new(1, 0.5, 0) }]);
        foreach (var id in new[] { "tri-uv", "dir-unnorm" })
        {
            var triangles = scene.Models.SelectMany<Model, Model>(model => model is not Mesh mesh
                ? [model]
                : Enumerable.Range(0, mesh.TriangleCount).Select(i => new Model<Triangle>(mesh[i]) { Color = mesh.Color }));
            Assert.Equal(Draw(scene with { Models = [.. triangles] }, id).Rgb, Draw(scene, id).Rgb);
        }
    }

    [Fact]
    public void AModelOfOnesOwnIsAskedForItsHits()
    {
        var scene = new Scene(new(new(0, -5, 0), Vector3.Zero) { Width = 8, Height = 8 }, [new Wall { Color = new(1, 0.5, 0) }]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Draw(scene).Rgb);
        Assert.Equal(((byte)0, (byte)128, (byte)255), Draw(scene, "bgr", "att-none")[4, 4]);
    }

    private static Picture Draw(Scene scene, params string[] ids) =>
        MistakeCatalog.Draw(scene, [.. ids.Select(id => MistakeCatalog.Named(id)!.Usual)]);

    /// <summary>y = 0, in plain doubles and ifs.</summary>
    private sealed class Wall : Model
    {
        public override double? Intersect(Ray ray)
        {
            var t = -ray.Origin.Y / ray.Direction.Y;
            return ray.Counts(t) ? t : null;
        }
    }
}
