using System.Collections.Concurrent;

namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>The wrong pictures are <see cref="EditedLab"/>'s.</summary>
public class DiagnosisTests
{
    internal static readonly Scene scene = SceneFolder.Small("mistakes/generic", 4);

    private static readonly ConcurrentDictionary<string, Lazy<DiagnosisResult>> diagnoses = [];

    /// <summary>Of the picture with a planted mistake: one search for all tests that read it.</summary>
    internal static DiagnosisResult OfPlanted(string id) => diagnoses.GetOrAdd(id, id => new(() =>
        DiagnosisResult.Find(scene, Planted(id), new()))).Value;

    internal static Picture Planted(string id)
    {
        var lab = new PictureDifference(EditedLab.Render(scene), ScalarRenderer.Render(scene));
        Assert.True(lab.Wrong <= 3, $"the lab (src/RayCaster.Lab) and the library (src/RayCaster) draw {lab.Wrong} pixels differently");
        return EditedLab.Render(scene, PlantedMistake.Named(id));
    }

    [Fact]
    public void AWarningIsInTheJsonOnlyIfThereIsOne()
    {
        var diagnosis = DiagnosisResult.Find(scene, EditedLab.Render(scene), new());
        var warned = DiagnosisReport.Json(diagnosis, default, default, [], "src/RayCaster has been changed.");
        Assert.Contains("\"warning\": \"src/RayCaster has been changed.\"", warned);
        Assert.DoesNotContain("warning", DiagnosisReport.Json(diagnosis, default, default, [], null));
    }

    [Fact]
    public void ATruncatedPictureMatchesAndIsSaidToBeDarker()
    {
        var diagnosis = OfPlanted("round");
        Assert.Equal(DiagnosisKind.Matches, diagnosis.Kind);
        Assert.Matches(
            @"mine\.png matches: .*\nIt is rounded otherwise: .* off by 1 level, but only 1 % may be\.\n.* one level darker: truncated",
            DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact]
    public void APictureThatIsRoundedUpMatchesAndIsSaidToBeLighter()
    {
        var lighter = ScalarRenderer.Render(scene);
        for (var i = 0; i < lighter.Rgb.Length; i += 2) lighter.Rgb[i] = (byte)Math.Min(255, lighter.Rgb[i] + 1);
        Assert.Matches(
            @"mine\.png matches: .*\nIt is rounded otherwise: .* off by 1 level, but only 1 % may be\.\n.* one level lighter: rounded up",
            DiagnosisReport.Text(DiagnosisResult.Find(scene, lighter, new()), "mine.png", "scene.json"));
    }

    [Fact]
    public void ALevelAddedEverywhereIsSaid()
    {
        var brighter = ScalarRenderer.Render(scene);
        for (var i = 0; i < brighter.Rgb.Length; i++) brighter.Rgb[i] = (byte)Math.Min(255, brighter.Rgb[i] + 1);
        Assert.Contains("are one level lighter", DiagnosisReport.Text(DiagnosisResult.Find(scene, brighter, new()), "mine.png", "scene.json"));
    }

    /// <summary>As screenshots make them. Nothing of the code is accused.</summary>
    [Theory]
    [InlineData(0, 1, 0, 0, "its first line")]
    [InlineData(0, 0, 1, 0, "its last column")]
    [InlineData(1, 0, 0, 1, "its last line and its first column")]
    public void ACroppedPictureIsRightButForThat(int left, int top, int right, int bottom, string missing)
    {
        var (whole, (width, height)) = (ScalarRenderer.Render(scene), (scene.Camera.Width, scene.Camera.Height));
        var mine = Picture.Create(width - left - right, height - top - bottom, (x, y) => whole[x + left, y + top]);
        var diagnosis = new Diagnoser(scene.WithSize(mine.Width, mine.Height), size: (width, height)).Diagnose(mine);
        Assert.Equal((DiagnosisKind.Cropped, 0, mine.Count), (diagnosis.Kind, diagnosis.Suspects.Count, diagnosis.PixelCount));
        Assert.Equal($"mine.png is the picture of scene.json without {missing}. Was it cropped on its way, for example by a screenshot?",
            DiagnosisReport.Text(diagnosis, "mine.png", "scene.json").ReplaceLineEndings(" ").TrimEnd());
    }

    /// <summary>A program that draws the scene in a size of its own is no screenshot.</summary>
    [Fact]
    public void ARightPictureOfAnotherSizeIsNotCalledCropped()
    {
        var smaller = scene.WithSize(scene.Camera.Width, scene.Camera.Height - 1);
        var size = (scene.Camera.Width, scene.Camera.Height);
        Assert.Equal(DiagnosisKind.Matches, new Diagnoser(smaller, size: size).Diagnose(ScalarRenderer.Render(smaller)).Kind);
    }

    [Fact(Explicit = true)]
    public void APictureThatIsAPixelAsideDoesNotMatch()
    {
        var right = ScalarRenderer.Render(scene);
        var moved = Picture.Create(right.Width, right.Height, (x, y) => right[(x + 1) % right.Width, y]);
        Assert.NotEqual(DiagnosisKind.Matches, DiagnosisResult.Find(scene, moved, new()).Kind);
    }

    [Fact]
    public void TheLastHitIsNamedWhereBothCrossingsOfABodyAreHits()
    {
        var open = scene with { Background = new(1, 0, 1) };
        var picture = ScalarRenderer.Render(open with { Models = [] });
        foreach (var model in open.Models) // each covers the ones before it, with its far side
        {
            var alone = MistakeCatalog.Draw(open with { Models = [model] },
                [MistakeCatalog.Named("far-root")!.Usual, MistakeCatalog.Named("slab-tmax")!.Usual]);
            for (var y = 0; y < alone.Height; y++)
                for (var x = 0; x < alone.Width; x++)
                    if (alone[x, y] != open.Background.ToBytes()) picture[x, y] = alone[x, y];
        }
        Assert.Equal(["last-hit"], DiagnosisResult.Find(open, picture, new()).Suspects[0].Mistakes.Select(mistake => mistake.Id));
    }

    [Theory]
    [InlineData("floor")]
    [InlineData("small ball")]
    [InlineData("high box")]
    [InlineData("sail")]
    public void AModelThatIsMissingIsNamed(string name)
    {
        var without = scene with { Models = [.. scene.Models.Where(model => model.Name != name)] };
        Assert.Equal($"`{name}`", DiagnosisResult.Find(scene, ScalarRenderer.Render(without), new(0)).MissingModel); // told without a search
    }

    [Fact]
    public void APictureOfNothingProvesNothing()
    {
        var empty = new Scene(new Camera(new(20, 0, 0), Vector3.Zero) { Width = 6, Height = 4 }, []);
        Assert.Contains("it proves nothing", DiagnosisReport.Text(DiagnosisResult.Find(empty, new Picture(6, 4), new()), "mine.png", "scene.json"));
    }

    [Fact]
    public void TheLastBitsOfASquarePictureAreNoMistake()
    {
        var room = SceneFolder.Read(SceneFolder.FileOf("room")); // the walls meet on its diagonals
        room = room.WithSize(166, 166);
        var picture = EditedLab.Render(room, new Manner(Truncates: true, Float: true));
        Assert.Equal(DiagnosisKind.Matches, DiagnosisResult.Find(room, picture, new()).Kind);
    }

    [Theory]
    [InlineData("best0", "There is nothing but background")]
    [InlineData("w-sign", "There is nothing but background")]
    [InlineData("att-int", "All that is drawn is black")]
    public void APictureThatVeryManyMistakesMakeDecidesNothing(string id, string says)
    {
        var wall = new Scene(new Camera(new(20, 0, 0), Vector3.Zero) { Width = 60, Height = 40 },
            [Model.Of(new Aabb(new(-5, -4, -4), new(0, 4, 4)))])
        {
            Background = new(0.2, 0.4, 0.6),
        };
        var diagnosis = DiagnosisResult.Find(wall, MistakeCatalog.Draw(wall, [MistakeCatalog.Named(id)!.Usual]), new());
        Assert.Equal((DiagnosisKind.TellsNothing, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        Assert.StartsWith(says, Assert.Single(diagnosis.Likely));
        Assert.Contains("so none is named", DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact(Explicit = true)]
    public void OfOneColourNoMistakeIsNamed()
    {
        var floor = new Scene(new Camera(new(0, -5, 2), new(0, 0, -2)) { Width = 30, Height = 20 },
            [new Model<Plane>(new(new(0, 0, -2), new(0, 0, 1))) { Color = new(0.9, 0.5, 0.2) }]);
        var corner = MistakeCatalog.Draw(floor, [MistakeCatalog.Named("pix-int")!.Usual]);
        Assert.True(corner.IsOneColor);
        Assert.Empty(DiagnosisResult.Find(floor, corner, new()).Suspects);

        Array.Fill(corner.Rgb, (byte)77);
        var grey = DiagnosisResult.Find(floor, corner, new());
        Assert.Equal((DiagnosisKind.TellsNothing, 0), (grey.Kind, grey.Suspects.Count));
        Assert.StartsWith("Every pixel has the same colour, (77, 77, 77)", Assert.Single(grey.Likely));
    }

    [Fact]
    public void NoEditOfAFormulaIsNamedForOneColour()
    {
        var first = SceneFolder.Small("first", 20);
        var picture = new Picture(first.Camera.Width, first.Camera.Height);
        for (var i = 0; i < picture.Rgb.Length; i++) picture.Rgb[i] = (byte)(1 + i % 3);
        var diagnosis = DiagnosisResult.Find(first, picture, new());
        Assert.Equal((DiagnosisKind.TellsNothing, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
    }

    [Fact]
    public void AFlatWhitePictureTellsNothing()
    {
        var white = Planted("att-none");
        var background = scene.Background.ToBytes();
        for (var y = 0; y < white.Height; y++)
            for (var x = 0; x < white.Width; x++)
                if (white[x, y] != background) white[x, y] = (255, 255, 255);
        var diagnosis = DiagnosisResult.Find(scene, white, new());
        Assert.Equal((DiagnosisKind.TellsNothing, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        Assert.StartsWith("All that is drawn is white", Assert.Single(diagnosis.Likely));
    }

    [Fact]
    public void ASymptomIsToldOnlyOfTheVariantThatItIsOf()
    {
        var mistake = MistakeCatalog.Named("zboth-t")!;
        var clipped = SceneFolder.Small("clip-depth", 5);
        Assert.True(DiagnosisResult.Find(clipped, MistakeCatalog.Draw(clipped, [mistake.Usual]), new()).Suspects[0].HasSymptoms);
        var other = mistake.Changes.First(variant => variant.Cause.EndsWith("planes, circles and triangles", StringComparison.Ordinal));
        var suspect = DiagnosisResult.Find(clipped, MistakeCatalog.Draw(clipped, [other]), new()).Suspects[0];
        Assert.Equal((other.Id, false), (suspect.Mistakes[0].Id, suspect.HasSymptoms));
    }

    [Fact(Explicit = true)]
    public void OfSwappedSidesThatNothingExplainsNoOutlineIsSought()
    {
        var small = SceneFolder.Small("mistakes/generic", 8);
        var picture = Renderer.Render(small.WithSize(small.Camera.Height, small.Camera.Width)); // the scene's colours
        Assert.Equal(DiagnosisKind.NoneOfThese, DiagnosisResult.Find(small, picture, new()).Kind);
    }

    [Fact]
    public void APictureOfAnotherSizeCannotBeDiagnosed() =>
        Assert.Throws<ArgumentException>(() => DiagnosisResult.Find(scene, new Picture(scene.Camera.Width + 1, scene.Camera.Height), new()));

    [Fact]
    public void EachLevelOfHintsTellsMore()
    {
        var diagnosis = OfPlanted("rows");
        var hint = diagnosis.Suspects[0].Mistakes[0].Hint;
        string Told(HintLevel level) =>
            DiagnosisReport.Text(diagnosis, "mine.png", "scene.json", level).ReplaceLineEndings(" ").Replace("            ", "");
        Assert.Equal((true, false, false), Holds(Told(HintLevel.Symptom)));
        Assert.Equal((true, true, false), Holds(Told(HintLevel.Question)));
        Assert.Equal((true, true, true), Holds(Told(HintLevel.Answer)));

        (bool, bool, bool) Holds(string text) => (text.Contains(hint.Symptom[..20]), text.Contains(hint.Question[..20]), text.Contains("Answer:"));
    }

    [Fact(Explicit = true)]
    public void AFewPixelsThatNobodyWouldSeeThereDoNotMatch()
    {
        var picture = ScalarRenderer.Render(scene);
        for (var i = 0; i < 16; i++) picture[50 + i % 4, 30 + i / 4] = (255, 0, 255);
        Assert.Equal(DiagnosisKind.NoneOfThese, DiagnosisResult.Find(scene, picture, new()).Kind);
    }

    [Fact(Explicit = true)]
    public void ARightPictureOfAnotherProgramMayHaveSingleOutlinePixelsOff()
    {
        var picture = ScalarRenderer.Render(scene);
        var y = picture.Height / 2;
        var x = Enumerable.Range(1, picture.Width - 1).First(x => PictureDifference.Levels(picture[x, y], picture[x - 1, y]) > 20);
        picture[x, y] = picture[x - 1, y];
        Assert.Equal(DiagnosisKind.Matches, DiagnosisResult.Find(scene, picture, new()).Kind);
    }

    [Fact(Explicit = true)]
    public void EqualPicturesOfTwoMistakesAreNamedOnceAndMarked()
    {
        var picture = MistakeCatalog.Draw(scene, [MistakeCatalog.Named("dir-unnorm")!.Usual, MistakeCatalog.Named("att-no2")!.Usual]);
        var suspects = DiagnosisResult.Find(scene, picture, new()).Suspects;
        var sets = suspects.Select(suspect => string.Join(' ', suspect.Mistakes.Select(mistake => mistake.Id).Order())).ToArray();
        Assert.Equal(sets.Distinct(), sets);
        Assert.Contains(suspects, suspect => suspect.SamePicture && suspect.Mistakes.Any(mistake => mistake.Id == "att-depth"));
        Assert.Contains(suspects, suspect => suspect.SamePicture && suspect.Mistakes.Any(mistake => mistake.Id == "dir-unnorm"));
    }

    [Fact(Explicit = true)]
    public void AForeignPictureHasNoneOfThem()
    {
        var camera = scene.Camera;
        var foreign = new Picture(camera.Width, camera.Height);
        new Random(1).NextBytes(foreign.Rgb);
        var diagnosis = DiagnosisResult.Find(scene, foreign, new());
        Assert.Equal((DiagnosisKind.NoneOfThese, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        Assert.StartsWith("This is another picture", Assert.Single(diagnosis.Likely));
    }

    internal static IEnumerable<string> Named(Suspect suspect) =>
        suspect.Mistakes.Select(mistake => mistake.Id).Concat(suspect.Twins.Select(twin => twin.Id));
}
