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
        var scene = SceneFolder.Small(name);
        Assert.Equal(Renderer.Render(scene).Rgb, new Lab(scene).Render().Rgb); // which is the scalar definition's, to the bit
    }

    [Fact]
    public void EachFormulaStyleIsRightByItself()
    {
        var scene = SceneFolder.Small("mistakes/generic");
        var right = Of().Render();
        var nothing = Mistake.Unnamed(_ => { });
        foreach (var style in MistakeCatalog.All.SelectMany(mistake => mistake.InStyles(nothing)).DistinctBy(style => style.Cause))
        {
            var evidence = new Evidence(scene, right, new Lab(scene, style).Render(), int.MaxValue);
            Assert.True(evidence.IsRight, $"{evidence.WrongCount} pixels are wrong{style.Cause}");
        }
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
        var scene = new Scene(new(new(0, -5, 0), Vector3.Zero) { Width = 8, Height = 8 }, [new Wall { Color = new(1, 0.5, 0) }]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, new Lab(scene).Render().Rgb);
        var lab = new Lab(scene, MistakeCatalog.Named("bgr")!, MistakeCatalog.Named("att-none")!);
        Assert.Equal(((byte)0, (byte)128, (byte)255), lab[4, 4]);
    }

    /// <summary>A ray at the box from (−1, −1, −1) to (1, 1, 1); P = (0, −5, 0).</summary>
    [Theory]
    [InlineData("plane-no-p", "B0 / d and B1 / d without P", 0, 1, 0, -1, 1)] // X = (0, −6, 0) and (0, −4, 0), x and z of which are in it
    [InlineData("slab-2axes", "only the next", 0, 1, 0.5, -2, 2)] // z = −1 and z = 1 at x = 0
    [InlineData("slab-2axes", "only the coordinate before", 0, 1, 0.5, 4, 6)] // y = −1 and y = 1 at x = 0
    public void ABoxIsAskedFaceByFace(string id, string variant, double x, double y, double z, double near, double far)
    {
        var crossed = Worded(id, $"box: face by face, {variant}").Box.Do(new(new(-1, -1, -1), new(1, 1, 1)), new(x, y, z));
        Assert.Equal((near, far), ((double)crossed.Near, (double)crossed.Far));
    }

    /// <summary>P = (0, −5, 0), C = (0, 0.5, 0), R = 6: tca = 0.5, so D = |(0, 5, 0)| and thc² = 36 − 25.</summary>
    [Fact]
    public void ASphereWithoutPInTcaIsMeasuredFromTheRay()
    {
        var crossed = Worded("plane-no-p", "sphere: tca = C·d, without P, and D = L − tca d").Sphere.Do(new(new(0, 0.5, 0), 6), new(0, 1, 0));
        Assert.Equal(0.5 - Math.Sqrt(11), (double)crossed.Near, 12);
        Assert.Equal(0.5 + Math.Sqrt(11), (double)crossed.Far, 12);
    }

    private static Lab Worded(string id, string cause) => new(new Scene(new(new(0, -5, 0), Vector3.Zero) { Width = 8, Height = 8 }, []),
        MistakeCatalog.Named(id)!.Variants.Single(variant => variant.Cause.StartsWith(cause, StringComparison.Ordinal)));

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
