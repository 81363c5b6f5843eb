namespace RayCaster.Teaching;

/// <summary>
/// Finds a change of the whole picture. Thousands of changes are tried on a few hundred pixels, and the best few on all pixels.
/// </summary>
/// <param name="before">The difference without a change; null if the sizes differ.</param>
/// <param name="holdAllWrong">Whether all wrong pixels of a difference are on outlines.</param>
internal sealed class ChangeFinder(
    Picture mine, Picture reference, PictureDifference? before, Func<PictureDifference, bool> holdAllWrong)
{
    /// <summary>The largest shift that is tried, in pixels.</summary>
    private const int MaxShift = 16;

    private const int SampleCount = 384, Finalists = 6, Edge = 12;

    /// <summary>A reported change leaves at most this percentage of all pixels wrong, and at most one in ten of the wrong ones.</summary>
    private const int Percent = 2, Part = 10;

    private readonly (int X, int Y)[] anywhere = [.. SomePlaces(reference).Take(SampleCount)];

    private readonly (int X, int Y)[] edges = [.. SomePlaces(reference).Skip(SampleCount).Take(50 * SampleCount)
        .Where(place => reference.IsEdge(place.X, place.Y, Edge)).Take(SampleCount)];

    /// <summary>The simplest change that makes the pictures agree, else the one that nearly does; null if there is none.</summary>
    public Recognition? Find()
    {
        // No change turns a picture of one colour into one of several.
        if (mine.IsOneColor || reference.IsOneColor) return null;
        var size = (reference.Width, reference.Height);
        var (hasItsSize, hasItsSidesSwapped) = ((mine.Width, mine.Height) == size, (mine.Height, mine.Width) == size);
        var shifts = Enumerable.Range(-MaxShift, 2 * MaxShift + 1).ToArray();
        var candidates =
            from turn in Enum.GetValues<Turn>()
            where TurnedPlaces.SwapsSides(turn) ? hasItsSidesSwapped : hasItsSize
            from down in shifts
            from right in shifts
            from colors in (ColorChange?[])[null, .. ColorChange.Orders, .. Tones(turn, right, down)]
            let change = new Change(turn, right, down, colors)
            where change != new Change()
            let misses = Misses(change)
            where misses is not null
            orderby misses, change.Complexity
            select change;
        IEnumerable<Change> ofBytes = hasItsSize ? ((int[])[-1, 1, -2, 2, -4, 4]).Select(bytes => new Change(Bytes: bytes))
            : hasItsSidesSwapped ? [new(SidesSwapped: true)] : [];

        return ofBytes.Concat(candidates.Take(Finalists)).Select(Recognise).Where(IsReported).MinBy(Rank);
    }

    private static IEnumerable<(int X, int Y)> SomePlaces(Picture picture)
    {
        for (var random = new Random(1); ;) yield return (random.Next(picture.Width), random.Next(picture.Height));
    }

    private Recognition Recognise(Change change)
    {
        var difference = new PictureDifference(change.Undo(mine, reference), reference);
        var verdict = Likenesses.Of(difference, holdAllWrong);
        // A guessed formula allows each byte a range that includes truncation, so it cannot tell exact, rounded and truncated bytes apart.
        if (change.Colors is { IsOrder: false } && change.Colors != ColorChange.Inverted)
            verdict = verdict switch
            {
                Likeness.Identical => Likeness.WithinRounding,
                Likeness.RoundedOtherwise => Likeness.Wrong,
                _ => verdict,
            };
        return new(change, difference, verdict);
    }

    private bool IsReported(Recognition r) =>
        r.Likeness != Likeness.Wrong
        || (r.Difference.Wrong > 0
            && r.Difference.Wrong * 100L <= (long)r.Difference.Pixels * Percent
            && (before is null || (long)r.Difference.Wrong * Part <= before.Wrong));

    private static (bool, int, int) Rank(Recognition r) =>
        (r.Likeness == Likeness.Wrong, r.Likeness == Likeness.Wrong ? r.Difference.Wrong : 0, r.Change.Complexity);

    /// <summary>How many samples differ after a change; null if they are too many.</summary>
    private int? Misses(Change change)
    {
        var pixels = new MendedPixels(change, mine, reference);
        var onEdges = Misses(pixels, edges, edges.Length * 3 / 5);
        return onEdges is null ? null : onEdges + Misses(pixels, anywhere, anywhere.Length / 20);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int? Misses(in MendedPixels pixels, (int X, int Y)[] samples, int limit)
    {
        var (misses, beside) = (0, 0);
        foreach (var (x, y) in samples)
        {
            if (pixels.At(x, y) is not { } mended)
            {
                if (++beside * 2 > samples.Length) return null;
            }
            else if (PictureDifference.Levels(mended, reference[x, y]) > 1 && ++misses > limit) return null;
        }
        return misses;
    }

    /// <summary>Formulas that may have changed the reference's channels to those of a picture that was turned, and moved by a pixel at
    /// most.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private List<ColorChange> Tones(Turn turn, int right, int down)
    {
        if (Math.Abs(right) > 1 || Math.Abs(down) > 1) return [];
        var pixels = new MendedPixels(new(turn, right, down), mine, reference);
        // Sums of least squares, over the channels that are neither black nor clamped: powers, factors, straight lines.
        double logs = 0, logSquares = 0, n = 0, sumA = 0, sumB = 0, sumAA = 0, sumAB = 0;
        foreach (var (x, y) in anywhere)
        {
            if (pixels.At(x, y) is not var (red, green, blue)) continue;
            var (r, g, b) = reference[x, y];
            Add(r, red);
            Add(g, green);
            Add(b, blue);
        }

        List<ColorChange> tones = [ColorChange.Inverted, ColorChange.Srgb];
        if (n == 0) return tones;
        if (logs / logSquares is var exponent and (> 0.2 and < 0.97 or > 1.03 and < 5)) tones.Add(ColorChange.Power(Plain(exponent)));
        if (sumAB / sumAA is var factor and (> 0.05 and < 0.98 or > 1.02 and < 20))
        {
            tones.Add(ColorChange.Linear(Math.Round(factor, 2), 0));
            tones.Add(ColorChange.Linear(factor, 0));
        }
        if ((sumB - sumA) / n is var levels && Math.Abs(levels) is > 1.5 and < 200) tones.Add(ColorChange.Linear(1, Math.Round(levels) / 255));
        var slope = (n * sumAB - sumA * sumB) / (n * sumAA - sumA * sumA);
        if (slope is > 0.05 and < 20) tones.Add(ColorChange.Linear(slope, (sumB - slope * sumA) / n / 255));
        return tones;

        void Add(double a, double b)
        {
            if (b is 0 or 255) return;
            (n, sumA, sumB, sumAA, sumAB) = (n + 1, sumA + a, sumB + b, sumAA + a * a, sumAB + a * b);
            if (a is < 12 or > 250) return;
            var log = Math.Log(a / 255);
            logs += log * Math.Log(b / 255);
            logSquares += log * log;
        }
    }

    /// <summary>A usual gamma, such as 1/2.2, in place of a number within 2 % of it.</summary>
    private static double Plain(double exponent)
    {
        double[] usual = [0.5, 1 / 2.2, 1 / 1.8, 1 / 2.4, 2, 2.2, 1.8, 2.4];
        return usual.FirstOrDefault(plain => Math.Abs(exponent / plain - 1) < 0.02, exponent);
    }
}
