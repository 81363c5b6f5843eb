namespace RayCaster.Teaching.Diagnosis;

/// <summary>
/// The pixels of a picture by which mistakes are judged. In half of them the picture differs from the right one, in half it does not, and they are
/// spread evenly. So a small fault counts although most of the picture is right.
/// </summary>
internal sealed class PictureSample
{
    /// <summary>In how many places it is looked whether a kind of shape is drawn where the picture shows it.</summary>
    private const int PlacesOfKind = 32;

    /// <summary>A mistake whose pixels may lie anywhere explains a pixel by chance: this part of it counts as unexplained.</summary>
    private const double Chance = 0.05;

    /// <summary>Of so many pixels one may differ in pictures that are the same.</summary>
    private const int MostAlike = 2000;

    /// <summary>If a greater share of the pixels is wrong, those on outlines do not matter.</summary>
    private const double FewPixels = 0.03;

    private readonly SearchBudget? budget;
    private readonly int most;
    private readonly int allWrong; // also those that a first mistake explains
    private readonly Lazy<Dictionary<string, (int X, int Y)[]>> shownKinds;
    private readonly Lazy<string[]> pieces;
    private readonly int[] wrongPixels, otherPixels; // places in the picture, each beginning of the list spread over all of it
    private readonly (int Pixel, bool IsWrong)[] pixels; // both by turns
    private readonly Rendering rendering;

    /// <param name="right">Its own picture; if it has another size, everything is wrong.</param>
    /// <param name="pixels">The most pixels that are compared; fewer in a scene of many models.</param>
    /// <param name="budget">What drawing spends; null if it is not counted.</param>
    public PictureSample(Scene scene, Picture right, Picture picture, int pixels, bool forgiveOutlines = true, SearchBudget? budget = null)
    {
        (Scene, Picture, Right, this.budget) = (scene, picture, right, budget);
        (Colors, shownKinds) = (new(scene), new(FindShownKinds));
        pieces = new(() => [.. shownKinds.Value.Keys.Where(ShowsOnlyAPieceOf)]);
        most = (int)Math.Clamp(pixels * 500L / Math.Max(1, scene.Models.Count), 300, pixels) / 2; // so that the time stays the same
        var difference = Difference = HasRightSize ? new PictureDifference(picture, right) : null;
        var judge = new PictureJudge(right, scene);
        List<int> wrong = [], other = [];
        for (var i = 0; i < PixelCount; i++)
            (difference is null || difference.IsWrong(i) ? wrong : other).Add(i);
        if (forgiveOutlines && difference is not null && wrong.Count <= FewPixels * PixelCount)
        {
            OutlineCount = wrong.Count;
            wrong = [.. judge.WrongPixels(difference)];
            OutlineCount -= wrong.Count;
        }
        WrongCount = allWrong = wrong.Count;
        IsOnlyOutlines = difference is not null && judge.AreStray(difference, wrong);
        (wrongPixels, otherPixels) = (Spread(wrong, most), Spread(other, most));
        (this.pixels, rendering) = ByTurns(FormulaProgram.Slides);
    }

    /// <summary>The same pixels as a sample for a second mistake: those that a first one does not explain count as wrong.</summary>
    public PictureSample(PictureSample whole, FormulaProgram first)
    {
        (Scene, Picture, Right, most, budget) = (whole.Scene, whole.Picture, whole.Right, whole.most, whole.budget);
        (shownKinds, Colors, pieces) = (whole.shownKinds, whole.Colors, whole.pieces);
        var drawn = whole.Draw(first);
        var isExplained = Enumerable.Range(0, whole.pixels.Length).OrderByDescending(i => whole.pixels[i].IsWrong)
            .ToLookup(i => PictureJudge.IsNear(At(drawn, i), Picture.At(whole.pixels[i].Pixel)), i => whole.pixels[i].Pixel);
        (wrongPixels, otherPixels) = ([.. isExplained[false]], [.. isExplained[true]]);
        WrongCount = (int)whole.Residual(first).Unexplained;
        allWrong = whole.allWrong;
        (pixels, rendering) = ByTurns(first with { ByteShift = 0 });
    }

    private PictureSample(PictureSample whole, int[] pixels)
    {
        (Scene, Picture, Right, most, budget) = (whole.Scene, whole.Picture, whole.Right, whole.most, whole.budget);
        (shownKinds, Colors, pieces) = (whole.shownKinds, whole.Colors, whole.pieces);
        (wrongPixels, otherPixels, WrongCount, allWrong) = (pixels, [], PixelCount, PixelCount);
        (this.pixels, rendering) = ByTurns(FormulaProgram.Slides);
    }

    /// <summary>Wrong pixels and others by turns, so that a beginning of them has as many of both, and what is drawn there.</summary>
    /// <param name="basis">What most programs that are drawn differ from by a little.</param>
    private ((int Pixel, bool IsWrong)[], Rendering) ByTurns(FormulaProgram basis)
    {
        var all = new (int Pixel, bool IsWrong)[wrongPixels.Length + otherPixels.Length];
        for (int i = 0, k = 0; k < all.Length; i++)
        {
            if (i < wrongPixels.Length) all[k++] = (wrongPixels[i], true);
            if (i < otherPixels.Length) all[k++] = (otherPixels[i], false);
        }
        return (all, new(Scene, PlacesOf(all), 1 + all.Length / MostAlike, budget, basis));
    }

    private (int X, int Y)[] PlacesOf(ReadOnlySpan<(int Pixel, bool IsWrong)> some)
    {
        var places = new (int X, int Y)[some.Length];
        for (var i = 0; i < some.Length; i++) places[i] = (some[i].Pixel % Picture.Width, some[i].Pixel / Picture.Width);
        return places;
    }

    /// <summary>The same pixels in another order, all of them taken for wrong, in which each colour that the picture shows counts alike: a mistake
    /// that draws most models right is near, even if a second one changes most of the picture.</summary>
    public PictureSample ByColors()
    {
        int[][] alike = [.. wrongPixels.Concat(otherPixels).GroupBy(pixel => Colors.ModelOf(Picture.At(pixel))).Select(same => same.ToArray())];
        return new(this, [.. Enumerable.Range(0, 2 * most).SelectMany(k => alike.Where(color => k < color.Length).Select(color => color[k]))]);
    }

    public Scene Scene { get; }

    /// <summary>Which models have a colour.</summary>
    public ColorMap Colors { get; }

    public Picture Right { get; }

    public Picture Picture { get; }

    public int PixelCount => Picture.Width * Picture.Height;

    public int WrongCount { get; }

    /// <summary>
    /// In how many more pixels the picture shows what the scene shows a thousandth of a pixel away. There the last bits of doubles or floats decide.
    /// That is not wrong, and must not count: a mistake that changes a camera's number by its last bit would explain it.
    /// </summary>
    public int OutlineCount { get; }

    /// <summary>Whether the wrong pixels are very few and show a neighbour's colour: what another program's floats may do to an outline.</summary>
    public bool IsOnlyOutlines { get; }

    /// <summary>How the picture differs from the right one; null if it has another size, and for a second mistake.</summary>
    public PictureDifference? Difference { get; }

    /// <summary>What the whole picture shows.</summary>
    public Observations Observe(int? threads) => new(Picture, Right, Difference,
        Difference is null ? null : new(Scene, Difference, threads), Scene, new(Right, Scene));

    /// <summary>Whether the picture has the size of the scene's own.</summary>
    public bool HasRightSize => (Right.Width, Right.Height) == (Picture.Width, Picture.Height);

    /// <summary>Whether it is the scene's picture, but for rounding and single pixels on outlines.</summary>
    public bool IsRight => WrongCount == 0 || IsOnlyOutlines;

    /// <summary>The fewest pixels that count: as many as a visible mistake changes, or as one compared pixel represents.</summary>
    public double LeastPixels => Math.Max(Rendering.LeastPixels, (double)WrongCount / most);

    /// <summary>Whether two programs draw the same picture, but for one pixel in two thousand.</summary>
    public bool AreAlike(FormulaProgram one, FormulaProgram other) => rendering.AreAlike(one, other);

    /// <summary>What a program draws in all pixels of the sample.</summary>
    private byte[] Draw(FormulaProgram program) => rendering.Draw(program, ..pixels.Length);

    /// <summary>The bits of the pixels that are left unexplained.</summary>
    public double BitsOf(Residual residual) => Priors.BitsOf(residual.Weight, allWrong);

    /// <summary>
    /// Whether the picture proves that another program drew it: it shows the colour of a kind of shape, but the program draws nothing of this kind,
    /// or nothing at these places although its mistake is one of this kind.
    /// </summary>
    /// <param name="isAbout">Whether a mistake of the program is one of a kind of shape alone.</param>
    public bool Contradicts(FormulaProgram program, Predicate<string> isAbout)
    {
        if (!CanDraw(program)) return false;
        if (program.HasNoisyTriangles && pieces.Value.Any(kind => isAbout(kind))) return true;
        var drawn = new Lazy<byte[]>(() => Draw(program));
        return Lost(program).Any(kind => isAbout(kind)
            || Enumerable.Range(0, pixels.Length).All(i => Colors.KindOf(At(drawn.Value, i)) != kind));
    }

    /// <summary>The kinds of shape that the picture shows, but a program does not draw at any of these places.</summary>
    /// <param name="other">A number that the scene gives otherwise; null for none.</param>
    public IEnumerable<string> Lost(FormulaProgram program, (int Part, Symbol Name, PixelValues Value)? other = null) =>
        from shown in shownKinds.Value
        let places = shown.Value
        let without = program with { HasNoisyTriangles = false }
        let drawn = other is null ? FormulaEvaluator.Draw(Scene, without, places, budget)
            : new FormulaEvaluator(Scene, places, other: other).Draw(without, budget)
        where !places.Index().Any(place => PictureJudge.IsNear(At(drawn, place.Index), Picture[place.Item.X, place.Item.Y]))
        select shown.Key;

    /// <summary>Whether the picture shows a kind of shape by its colour.</summary>
    public bool Shows(string kind) => shownKinds.Value.ContainsKey(kind);

    /// <summary>Whether the picture shows few pixels of a kind of shape, but these in a piece: last bits would scatter them.</summary>
    private bool ShowsOnlyAPieceOf(string kind)
    {
        var shown = Enumerable.Range(0, Picture.Count).Count(i => IsOf(Picture, i));
        var beside = Enumerable.Range(0, Picture.Count - 1).Count(i => IsOf(Picture, i) && IsOf(Picture, i + 1));
        return shown < 0.3 * Enumerable.Range(0, Right.Count).Count(i => IsOf(Right, i)) && beside > 0.6 * shown;

        bool IsOf(Picture picture, int i) => Colors.KindOf(picture.At(i)) == kind;
    }

    /// <summary>The share that a program explains of those wrong pixels that show certain colours; 0 if none does.</summary>
    public double ShareExplained(FormulaProgram program, Predicate<(byte, byte, byte)> ofColor)
    {
        if (!CanDraw(program)) return 0;
        var drawn = Draw(program);
        int[] places = [.. Enumerable.Range(0, pixels.Length).Where(i => pixels[i].IsWrong && ofColor(Picture.At(pixels[i].Pixel)))];
        return places.Length == 0 ? 0
            : (double)places.Count(i => PictureJudge.IsNear(At(drawn, i), Picture.At(pixels[i].Pixel))) / places.Length;
    }

    /// <summary>An estimate of how many pixels a program leaves unexplained; all of them for none.</summary>
    /// <param name="share">The share of the chosen pixels that is compared; few show that a mistake is far off.</param>
    public Residual Residual(FormulaProgram? program, double share = 1)
    {
        if (program is null || !CanDraw(program)) return new(PixelCount, PixelCount); // nothing is explained
        var some = Compared(share);
        return ResidualOf(rendering.Draw(program, some),
            program.HasNoisyTriangles ? rendering.Draw(program with { HasNoisyTriangles = false }, some) : null);
    }

    /// <summary>The same of a program for which the scene gives another number.</summary>
    public Residual Residual(FormulaProgram program, (int Part, Symbol Name, PixelValues Value) other, double share)
    {
        return ResidualOf(new FormulaEvaluator(Scene, PlacesOf(pixels[Compared(share)]), other: other).Draw(program, budget), null);
    }

    /// <summary>The pixels that are a share of those that are compared.</summary>
    private Range Compared(double share)
    {
        var count = (int)Math.Ceiling(most * share);
        return ..(Math.Min(wrongPixels.Length, count) + Math.Min(otherPixels.Length, count));
    }

    /// <param name="rgb">What is drawn in the first pixels.</param>
    /// <param name="unaffected">What is drawn there if last bits spare a pixel; null if they do not matter.</param>
    private Residual ResidualOf(byte[] rgb, byte[]? unaffected)
    {
        var wrong = (Count: 0, Left: default(Residual));
        var other = wrong;
        for (var k = 0; k < rgb.Length / 3; k++)
        {
            var shown = Picture.At(pixels[k].Pixel);
            var difference = PictureDifference.Levels(At(rgb, k), shown);
            var unexplained = 0.0;
            if (unaffected is not null)
            {
                var spared = PictureDifference.Levels(At(unaffected, k), shown);
                if (spared > PictureJudge.Tolerance && difference <= PictureJudge.Tolerance) unexplained = Chance;
                difference = Math.Min(difference, spared);
            }
            if (difference > PictureJudge.Tolerance) unexplained++;
            ref var sum = ref pixels[k].IsWrong ? ref wrong : ref other;
            sum = (sum.Count + 1, sum.Left + new Residual(unexplained, difference / 255.0));
        }
        return wrong.Left * (WrongCount / Math.Max(1.0, wrong.Count)) + other.Left * ((PixelCount - WrongCount) / Math.Max(1.0, other.Count));
    }

    private static (byte, byte, byte) At(byte[] rgb, int i) => (rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);

    /// <summary>Some of the pixels that show a colour that only one kind of shape has, for each kind that shows.</summary>
    private Dictionary<string, (int X, int Y)[]> FindShownKinds() => Enumerable.Range(0, Picture.Count)
        .ToLookup(i => Colors.KindOf(Picture.At(i)) ?? "", i => (i % Picture.Width, i / Picture.Width))
        .Where(kind => kind.Key != "" && kind.Count() >= FaultLocalization.LeastShown).ToDictionary(kind => kind.Key, kind =>
        {
            (int, int)[] all = [.. kind];
            var places = new GoldenRatioSequence(all.Length);
            return Enumerable.Range(0, Math.Min(all.Length, PlacesOfKind)).Select(k => all[places[k]]).ToArray();
        });

    private bool CanDraw(FormulaProgram program) => program.SizeOf(Scene.Camera) == (Picture.Width, Picture.Height);

    /// <summary>Takes some of a list, so that any beginning of them is spread over the whole list.</summary>
    private static int[] Spread(List<int> all, int most)
    {
        var place = new GoldenRatioSequence(Math.Max(1, all.Count));
        return [.. Enumerable.Range(0, Math.Min(all.Count, most)).Select(k => all[place[k]])];
    }
}
