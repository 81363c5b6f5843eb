namespace RayCaster.Teaching.Tests.Course;

/// <summary>Hints of the lab's picture tests, for programs with a mistake in the code of a step.</summary>
public class StepHintTests
{
    [Theory]
    [InlineData("plane")]
    [InlineData("room", Explicit = true)]
    [InlineData("mistakes/generic", Explicit = true)]
    public void BlackModelsAreToldAsLostLight(string file)
    {
        foreach (var formula in (string[])["1 - t / 2·|T - P|", "min(0, 1 - t / (2·|T - P|))"])
        {
            var (hint, finding) = Hint(file, 5, ProgramInWords.Written($"light att = max(0, {formula})"));
            Assert.Equal(DiagnosisKind.TellsNothing, finding);
            Assert.Contains("light is lost", hint);
            Assert.Contains("1 − t / (2 |T − P|)", hint);
            Assert.DoesNotContain(MistakeCatalog.Named("w-sign")!.Hint.Question, hint);
        }
    }

    [Theory]
    [InlineData("inside-box")]
    [InlineData("bias", Explicit = true)]
    public void AShapeThatIsGoneIsNamedAndNoMistake(string file)
    {
        var (hint, finding) = Hint(file, 7, MistakeCatalog.Named("slab-noswap")!.Usual);
        Assert.Equal(DiagnosisKind.TellsNothing, finding);
        Assert.StartsWith("  Missing where it should show: aabb.", hint);
        Assert.Contains("What if d is negative?", hint);
    }

    [Theory]
    [InlineData("plane", Explicit = true)]
    [InlineData("mistakes/generic")]
    public void WhatALaterStepWritesIsNoMistake(string file)
    {
        var plus = MistakeCatalog.Named("dir-plus-w")!.Usual;
        var (hint, _) = Hint(file, 4, plus, MistakeCatalog.Named("no-znear")!.Usual, MistakeCatalog.Named("no-zfar")!.Usual);
        Assert.Contains(plus.Hint.Question, hint);
        Assert.DoesNotContain("zNear", hint);
        Assert.DoesNotContain("zFar", hint);
    }

    [Fact]
    public void WhereOnlyAFewPixelsDifferNoMistakeIsRuledOut()
    {
        var scene = LabSteps.SceneAt(SceneFolder.Read(SceneFolder.FileOf("plane")), 4);
        var picture = MistakeCatalog.Draw(scene, [MistakeCatalog.Named("u-unnorm")!.Usual, MistakeCatalog.Named("att-none")!.Usual]);
        Assert.StartsWith("  Only a few pixels are wrong: too few to name a mistake.\n  Ask yourself: Take the ray of one pixel",
            StepHint.Format(scene, picture, 4, HintLevel.Question));
    }

    [Fact]
    public void ABlackPictureOfALaterStepIsTheShapesAndNotTheLights()
    {
        var scene = LabSteps.SceneAt(SceneFolder.Small("sphere", 5), 8);
        var black = Picture.Create(scene.Camera.Width, scene.Camera.Height, (_, _) => (0, 0, 0));
        Assert.Equal("""
              Missing where it should show: sphere.
              Ask yourself: Take a ray through the centre: what are t_ca, D and t_hc? What if the camera is inside?
            """, StepHint.Format(scene, black, 8, HintLevel.Question));
    }

    [Fact(Explicit = true)]
    public void AHitThatIsStoredAtInfinityIsNoMistakeOfTheAxes()
    {
        var (hint, _) = Hint("mistakes/generic", 4, ProgramInWords.Written("plane t = ∞·((Q - P)·n / den)²"));
        Assert.StartsWith("  There is nothing but background", hint);
        Assert.DoesNotContain(MistakeCatalog.Named("w-sign")!.Hint.Question, hint);
    }

    [Theory]
    [InlineData("clip-depth", Explicit = true)]
    [InlineData("far-plane", Explicit = true)]
    public void DividedDepthIsAVariantWhoseSymptomIsNotClaimed(string file)
    {
        var (hint, _) = Hint(file, 6, ProgramInWords.Written("depth z = t / (-d·W)"));
        Assert.StartsWith($"  Ask yourself: {MistakeCatalog.Named("zboth-t")!.Hint.Question}", hint);
    }

    /// <summary>With the divided depth nothing is nearer than zNear here, as if zNear was forgotten.</summary>
    [Fact(Explicit = true)]
    public void OfMistakesThatDrawTheSameTheUsualVariantIsNamed()
    {
        var (hint, _) = Hint("near-plane", 6, ProgramInWords.Written("depth z = t / (-d·W)"));
        Assert.StartsWith("  " + MistakeCatalog.Named("no-znear")!.Hint.Symptom, hint);
    }

    [Theory]
    [InlineData(7, "aabb", "slab-noswap")]
    [InlineData(7, "inside-box", "slab-inside", Explicit = true)]
    [InlineData(8, "inside-sphere", "oc-sign", Explicit = true)]
    public void TheMistakeOfTheStepIsNamedBeforeOthersThatDrawTheSame(int step, string file, string id)
    {
        var mistake = MistakeCatalog.Named(id)!.Usual;
        var (hint, _) = Hint(file, step, mistake);
        Assert.StartsWith($"  {mistake.Hint.Symptom}\n  Ask yourself: {mistake.Hint.Question}", hint);
    }

    [Fact]
    public void AMistakeThatExplainsAllPixelsIsAskedAboutInItsOwnStepOnly()
    {
        var mistake = MistakeCatalog.Named("slab-noswap")!.Usual;
        var scene = LabSteps.SceneAt(SceneFolder.Small("aabb", 5), 7);
        var picture = MistakeCatalog.Draw(scene, [mistake]);
        Assert.Contains($"Ask yourself: {mistake.Hint.Question}", StepHint.OfAllPixels(scene, picture, 7, HintLevel.Question));
        Assert.Equal("", StepHint.OfAllPixels(scene, picture, 4, HintLevel.Question));
    }

    [Theory]
    [InlineData("plane", Explicit = true)]
    [InlineData("room", Explicit = true)]
    [InlineData("mistakes/generic", Explicit = true)]
    public void MultipliedByDnIsAVariantOfThePlanes(string file)
    {
        var (hint, _) = Hint(file, 4, ProgramInWords.Written("plane t = (Q - P)·n·den"));
        Assert.Contains(MistakeCatalog.Named("plane-sign")!.Hint.Question, hint);
    }

    [Fact(Explicit = true)]
    public void ANormalisedNormalIsAVariantOfTheTriangles()
    {
        var (hint, _) = Hint(
            "mistakes/generic", 10, ProgramInWords.Written("triangle/shares u = n·((A - C) × (X - C)) / |n|; v = n·((B - A) × (X - A)) / |n|"));
        Assert.Contains(MistakeCatalog.Named("tri-uv")!.Hint.Question, hint);
    }

    /// <summary>What is told of a lab's picture at a step, without light at the first picture's.</summary>
    private static (string Hint, DiagnosisKind Finding) Hint(string file, int step, params Change[] planted)
    {
        var scene = LabSteps.SceneAt(SceneFolder.Small(file, 5), step);
        var picture = MistakeCatalog.Draw(scene, step < 5 ? [.. planted, MistakeCatalog.Named("att-none")!.Usual] : planted);
        var diagnosis = StepHint.Diagnose(scene, picture, step);
        return (StepHint.Format(scene, diagnosis, step, HintLevel.Question), diagnosis.Kind);
    }
}
