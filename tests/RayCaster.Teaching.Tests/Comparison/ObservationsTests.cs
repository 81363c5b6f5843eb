namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>What a picture shows without its formulas, by values, places and models: "compare" and "diagnose" say the same.</summary>
public class ObservationsTests
{
    private static readonly Scene generic = SceneFolder.Small("mistakes/generic", 4);
    private static readonly Picture right = Renderer.Render(generic), still = SomePictures.Still();

    [Theory]
    [InlineData("sign lost", "128 becomes 0", "below 128 all are right")]
    [InlineData("seven bits", "128 becomes 0", "below 128 all are right")]
    [InlineData("digits", "All outlines are right, the bytes are not")]
    [InlineData("brighter", "0 becomes 20")]
    [InlineData("gamma and BGR", "Read as BGR it is right but for its values", "All outlines are right")]
    public void AByteFollowsFromTheRightOne(string how, params string[] says) => Says(right.Map(p => how switch
    {
        "sign lost" => Each(p, value => value < 128 ? value : 0),
        "seven bits" => Each(p, value => value & 127),
        "digits" => Each(p, value => int.Parse(string.Concat($"{value}".Reverse()), CultureInfo.InvariantCulture)),
        "brighter" => Each(p, value => value + 20),
        _ => Each((p.B, p.G, p.R), value => (int)(255 * Math.Pow(value / 255.0, 0.45))),
    }), says);

    [Theory]
    [InlineData(2, 0, "With each line moved by 2 bytes more than the one above it is right")]
    [InlineData(-1, 0, "With each line moved by 1 byte more than the one above it is right")]
    [InlineData(0, 3, "With each line moved by 3 bytes more than the one above it is right")]
    public void EachLineBeginsSomeBytesLater(int skipped, int inserted, string says)
    {
        var (picture, line) = (new Picture(right.Width, right.Height), 3 * right.Width);
        for (var i = 0; i < picture.Rgb.Length; i++)
        {
            var from = inserted == 0 ? i + skipped * (i / line) : i % (line + inserted) < line
                ? i / (line + inserted) * line + i % (line + inserted) : -1;
            if (from >= 0 && from < right.Rgb.Length) picture.Rgb[i] = right.Rgb[from];
        }
        Says(picture, says);
    }

    [Theory]
    [InlineData(0.02, false, ", (0, 0, 0); all others are right, so no formula is wrong")]
    [InlineData(0.1, true, "single pixels, spread over the picture, are wrong; all others are right")]
    public void LostPixelsAreNoModels(double share, bool fromElsewhere, string says)
    {
        var random = new Random(1);
        Says(Picture.Create(right.Width, right.Height, (x, y) => random.NextDouble() > share ? right[x, y]
            : fromElsewhere ? right[random.Next(right.Width), random.Next(right.Height)] : default), says);
    }

    [Fact]
    public void ALineThatWasBegunIsOneOfThoseThatWereNotReached() => Says(
        Picture.Create(right.Width, right.Height, (x, y) => y < 30 || y == 30 && x < 20 ? right[x, y] : default),
        $"The last {right.Height - 31} lines are (0, 0, 0): does your loop reach them?");

    [Fact] // one model of the scene is black
    public void BlackBlocksAreNoKindsFault()
    {
        var random = new Random(1);
        var isLost = Enumerable.Range(0, 1000).Select(_ => random.NextDouble() < 0.1).ToArray();
        Assert.DoesNotContain("formula", ComparisonText.Format(new(Picture.Create(right.Width, right.Height,
            (x, y) => isLost[y / 8 * 30 + x / 8] ? default : right[x, y]), right, generic), "mine", "right"));
    }

    [Fact]
    public void ABlackPictureOnAnotherBackgroundIsAboutItsBytes() => Says(
        Picture.Create(right.Width, right.Height, (x, y) => x == y && x < 9 ? right[x, y] : default),
        "The picture is black, and the background is not: are the bytes written");

    [Fact] // all is too bright, and some pixels are lost
    public void OutlinesThatAreThereAreNotCalledOthers()
    {
        var (random, flat) = (new Random(1), MistakeCatalog.Draw(generic, [MistakeCatalog.Named("att-none")!.Usual]));
        Assert.DoesNotContain("The outlines are others", ComparisonText.Format(new(Picture.Create(right.Width, right.Height,
            (x, y) => random.NextDouble() < 0.02 ? default : flat[x, y]), right, generic), "mine", "right"));
    }

    [Fact]
    public void HolesOfOneKindAreNotTheLight()
    {
        var (random, hits) = (new Random(1), new Renderer(generic, 1).CastHits());
        Assert.Contains("full of holes", ComparisonText.Format(new(Picture.Create(right.Width, right.Height, (x, y) =>
            generic.Models[Math.Max(0, hits.Model[y * right.Width + x])].Kind != "aabb" || hits.Model[y * right.Width + x] < 0
            || random.NextDouble() > 0.3 ? right[x, y]
            : ((byte)(0.8 * right[x, y].R), (byte)(0.8 * right[x, y].G), (byte)(0.8 * right[x, y].B))), right, generic), "mine", "right"));
    }

    [Fact] // light is the same for all boxes, and some are right
    public void HolesInSomeModelsAreNotTheLight()
    {
        var scene = generic with { Models = [.. generic.Models.Where(model => model.Kind == "aabb")] };
        var (drawn, hits) = (Renderer.Render(scene), new Renderer(scene, 1).CastHits());
        var mine = Picture.Create(drawn.Width, drawn.Height, (x, y) =>
            (x * 7 + y * 3) % 5 > 1 || hits.Model[y * drawn.Width + x] is not (0 or 1) ? drawn[x, y]
            : ((byte)(0.8 * drawn[x, y].R), (byte)(0.8 * drawn[x, y].G), (byte)(0.8 * drawn[x, y].B)));
        Assert.DoesNotContain("the light is not", ComparisonText.Format(new(mine, drawn, scene), "mine", "right"));
    }

    [Fact] // four of them lie behind others, and uncover them
    public void SeveralMissingModelsAreNamed()
    {
        Model[] small = [.. Enumerable.Range(-6, 12)
            .Select(y => Model.Of(new Triangle(new(6, y, 0), new(6, y + 1, 0), new(6 - (y + 6) % 3, y, 1))))];
        foreach (var (i, model) in small.Index()) (model.Name, model.Color) = ($"small {i}", new(0.1 + 0.05 * i, 0.9 - 0.05 * i, 0.5));
        var scene = generic with { Models = [.. generic.Models, .. small] };
        var mine = Renderer.Render(generic);
        Assert.Contains("All other triangles are larger", ComparisonText.Format(new(mine, Renderer.Render(scene), scene), "mine", "right"));
        Assert.Contains("All other triangles are larger", Assert.Single(DiagnosisResult.Find(scene, mine, new()).Likely));
    }

    [Fact] // however small: the scene without the other one would show it
    public void AModelThatAMissingOneHidesIsMissing()
    {
        var front = Model.Of(new Triangle(new(6, -2, 0), new(6, 2, 0), new(6, 0, 2)));
        var behind = Model.Of(new Triangle(new(5, -1.05, 0), new(5, -0.55, 0), new(5, -0.8, 0.5)));
        (front.Name, front.Color, behind.Name, behind.Color) = ("front", new(0.9, 0.1, 0.1), "behind", new(0.1, 0.9, 0.1));
        var scene = generic with { Models = [.. generic.Models, front, behind] };
        Assert.Contains("`front`, `behind` are missing",
            ComparisonText.Format(new(Renderer.Render(generic), Renderer.Render(scene), scene), "mine", "right"));
    }

    /// <summary>What must be done to the picture is the opposite of what was done.</summary>
    [Theory]
    [InlineData("Flipped top to bottom it is right: are rows written upside down?")]
    [InlineData("Mirrored left to right it is right")]
    [InlineData("Turned by 180° it is right")]
    [InlineData("Transposed it is right")]
    [InlineData("Turned by 90° clockwise it is right")]
    [InlineData("Turned by 90° counter-clockwise it is right")]
    [InlineData("Transposed and turned by 180° it is right")]
    [InlineData("Moved 1 pixel to the left it is right")]
    [InlineData("Moved 1 line down it is right")]
    [InlineData("Flipped top to bottom and moved 1 line down it is right")]
    [InlineData("With its bytes moved by 2 towards the beginning it is right")]
    [InlineData("With width and height swapped in its header it is right")]
    public void OtherPlacesAreFound(string says)
    {
        var (w, h) = (still.Width, still.Height);
        var mine = says.Split(" it is")[0] switch
        {
            "Flipped top to bottom" => Picture.Create(w, h, (x, y) => still[x, h - 1 - y]),
            "Mirrored left to right" => Picture.Create(w, h, (x, y) => still[w - 1 - x, y]),
            "Turned by 180°" => Picture.Create(w, h, (x, y) => still[w - 1 - x, h - 1 - y]),
            "Transposed" => Picture.Create(h, w, (x, y) => still[y, x]),
            "Turned by 90° clockwise" => Picture.Create(h, w, (x, y) => still[w - 1 - y, x]),
            "Turned by 90° counter-clockwise" => Picture.Create(h, w, (x, y) => still[y, h - 1 - x]),
            "Transposed and turned by 180°" => Picture.Create(h, w, (x, y) => still[w - 1 - y, h - 1 - x]),
            "Moved 1 pixel to the left" => Picture.Create(w, h, (x, y) => x == 0 ? default : still[x - 1, y]),
            "Moved 1 line down" => Picture.Create(w, h, (x, y) => y == h - 1 ? default : still[x, y + 1]),
            "Flipped top to bottom and moved 1 line down" => Picture.Create(w, h, (x, y) => y == 0 ? default : still[x, h - y]),
            _ => Moved(says.Contains("swapped", StringComparison.Ordinal)),
        };
        Assert.Contains(says, ComparisonText.Format(new(mine, still), "mine", "right"), StringComparison.Ordinal);

        static Picture Moved(bool isSwapped)
        {
            var (moved, by) = (isSwapped ? new Picture(still.Height, still.Width) : new(still.Width, still.Height), isSwapped ? 0 : 2);
            still.Rgb.AsSpan(0, still.Rgb.Length - by).CopyTo(moved.Rgb.AsSpan(by));
            return moved;
        }
    }

    [Fact]
    public void WhatIsLeftWrongIsTold()
    {
        var mine = Picture.Create(96, 64, (x, y) => still[x, 63 - y]).With(p => p[3, 3] = p[4, 4] = (9, 9, 9));
        Assert.Contains("Flipped top to bottom it is nearly right, but for 2 of ", ComparisonText.Format(new(mine, still), "mine", "right"));
    }

    [Fact]
    public void NothingIsClaimedOfAMissingBall() => Assert.DoesNotContain("outlines are right",
        ComparisonText.Format(new(still.Map(p => p.B == 20 ? ((byte)0, (byte)0, (byte)0) : p), still), "mine", "right"));

    private static void Says(Picture mine, params string[] says)
    {
        var compared = ComparisonText.Format(new(mine, right, generic), "mine", "right");
        var diagnosed = Assert.Single(DiagnosisResult.Find(generic, mine, new()).Likely);
        Assert.All(says, sentence => Assert.Contains(sentence, diagnosed, StringComparison.Ordinal));
        Assert.Contains(diagnosed, compared, StringComparison.Ordinal);
    }

    private static (byte, byte, byte) Each((byte R, byte G, byte B) p, Func<int, int> change)
    {
        return (Of(p.R), Of(p.G), Of(p.B));

        byte Of(byte value) => (byte)Math.Clamp(change(value), 0, 255);
    }
}
