namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>What a lab draws: the definition, and with mistakes what they say, one on top of the other.</summary>
public class LabTests
{
    public static TheoryData<string> Scenes =>
        [.. SceneFolder.Files("scenes").Concat(SceneFolder.Files("scenes/mistakes")).Select(SceneFolder.NameOf)];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void WithoutAMistakeEveryByteIsTheDefinitions(string name)
    {
        var scene = SceneFolder.Small(name, 4);
        Assert.Equal(Renderer.Render(scene).Rgb, new Lab(scene).Render().Rgb); // which is the scalar definition's, to the bit
    }

    [Fact]
    public void StepsByOtherRightFormulasDrawTheSame()
    {
        var scene = SceneFolder.Small("mistakes/generic", 5);
        var (right, slides) = (new Lab(scene).Render(), FormulaProgram.For(scene.Camera));
        foreach (var kind in Enum.GetValues<SectionKind>().Except([SectionKind.File, SectionKind.Rule])) // the scene says which
        {
            foreach (var section in FormulaBook.Slides.StylesOf(kind).Where(section => section != slides[kind]))
            {
                var lab = new Lab(scene, Mistake.Unnamed(lab => lab.Follow(slides.With(section))));
                var evidence = new Evidence(scene, right, lab.Render(), int.MaxValue);
                Assert.True(evidence.IsRight, $"[{section.Name}]: {evidence.WrongCount} pixels are wrong");
            }
        }
    }

    [Theory]
    [InlineData("Vectors", "√(a.x² + a.y² + a.z²)", "len-nosqrt")]
    [InlineData("Camera", "up × W", "u-cross")]
    [InlineData("Pixel", "w / 2", "no-center")]
    [InlineData("File", "height − 1", "row-off")]
    [InlineData("Aabb", "tmin ≤ tmax", "slab-minmin")]
    [InlineData("Rule", "bias", null)]
    [InlineData("Light", "2·|T − P|", "att-no2")]
    [InlineData("Bytes", "255", null)]
    public void AnEditIsDrawnAsTheEvaluatorOfFormulasDrawsIt(string step, string meant, string? label)
    {
        var scene = SceneFolder.Small("mistakes/generic");
        var slides = FormulaProgram.For(scene.Camera);
        var edit = EditFactory.EditsOf(slides[Enum.Parse<SectionKind>(step)]).First(edit => edit.Meant == meant && edit.Label == label);
        (int X, int Y)[] pixels = [.. Enumerable.Range(0, 60).Select(i => (i * 7 % scene.Camera.Width, i * 5 % scene.Camera.Height))];
        var lab = new Lab(scene, Mistake.Unnamed(lab => lab.Follow(edit.In(slides))));
        byte[] drawn = [.. pixels.SelectMany<(int X, int Y), byte>(pixel => lab[pixel.X, pixel.Y] is var (r, g, b) ? [r, g, b] : [])];
        Assert.Equal(new FormulaEvaluator(scene, pixels, slides).Draw(edit.In(slides)), drawn);
    }

    /// <summary>A name that a lab does not know would be no value at all.</summary>
    [Fact]
    public void AnEditReadsOnlyWhatALabKnows() => EditsReadOnlyWhatALabKnows(8);

    /// <param name="step">1 for all edits, 8 for each eighth.</param>
    internal static void EditsReadOnlyWhatALabKnows(int step)
    {
        var scene = SceneFolder.Small("mistakes/generic");
        var slides = FormulaProgram.For(scene.Camera);
        var sections = Enum.GetValues<SectionKind>().SelectMany(FormulaBook.Slides.StylesOf);
        // One pixel of each model: a ray that passes a triangle by does not try its formulas.
        var shown = new Renderer(scene).CastHits().Model;
        int[] places = [.. Enumerable.Range(0, shown.Length).DistinctBy(place => shown[place])];
        Parallel.ForEach(sections.SelectMany(EditFactory.EditsOf).Where((_, i) => i % step == 0), edit =>
        {
            var lab = new Lab(scene, Mistake.Unnamed(lab => lab.Follow(edit.In(slides))));
            foreach (var place in places) Assert.Null(Record.Exception(() => lab[place]));
        });
    }

    [Fact]
    public void SinglePixelsAreThoseOfTheWholePictureOnAnyThread()
    {
        var lab = new Lab(
            SceneFolder.Read(SceneFolder.FileOf("mistakes/portrait")), MistakeCatalog.Named("whswap")!, MistakeCatalog.Named("tri-uv")!);
        var whole = lab.Render();
        Assert.Equal((lab.Width, lab.Height), (whole.Width, whole.Height));
        Parallel.For(0, 300, i =>
        {
            var (x, y) = (i * 7919 % lab.Width, i * 104729 % lab.Height);
            Assert.Equal(whole[x, y], lab[x, y]);
        });
    }

    [Fact]
    public void FileMistakesAddUp()
    {
        var lab = Of("rows", "bgr");
        var right = Of();
        for (var y = 0; y < lab.Height; y++)
        {
            for (var x = 0; x < lab.Width; x++)
            {
                var (r, g, b) = right[x, lab.Height - 1 - y];
                Assert.Equal((b, g, r), lab[x, y]);
            }
        }
    }

    [Fact]
    public void AMeshIsHitAsItsTrianglesAre()
    {
        var scene = SceneFolder.Read(SceneFolder.FileOf("mesh"));
        foreach (var id in new[] { "tri-cull", "tri-uv", "no-t0", "dir-unnorm" })
        {
            var triangles = scene.Models.SelectMany<Model, Model>(model => model is not Mesh mesh
                ? [model]
                : Enumerable.Range(0, mesh.TriangleCount).Select(i => new Model<Triangle>(mesh[i]) { Color = mesh.Color }));
            var mistake = MistakeCatalog.Named(id)!;
            var (whole, single) = (new Lab(scene, mistake), new Lab(scene with { Models = [.. triangles] }, mistake));
            for (var i = 0; i < 150; i++)
            {
                var (x, y) = (i * 7919 % whole.Width, i * 104729 % whole.Height);
                Assert.Equal(single[x, y], whole[x, y]);
            }
        }
    }

    [Fact]
    public void AModelOfOnesOwnIsAskedForItsHits()
    {
        var scene = new Scene(new(new(0, -5, 0), Vector3.Zero, width: 8, height: 8), [new Wall { Color = new(1, 0.5, 0) }]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, new Lab(scene).Render().Rgb);
        var lab = new Lab(scene, MistakeCatalog.Named("bgr")!, MistakeCatalog.Named("att-none")!);
        Assert.Equal(((byte)0, (byte)128, (byte)255), lab[4, 4]);
    }

    private static Lab Of(params string[] ids) =>
        new(SceneFolder.Small("mistakes/generic"), [.. ids.Select(id => MistakeCatalog.Named(id)!)]);

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
