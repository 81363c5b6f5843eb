namespace RayCaster.Teaching.Comparison;

/// <summary>
/// Finds a change of the whole picture. Thousands of changes are tried on a few hundred pixels, and the best few on all pixels.
/// </summary>
/// <param name="before">The difference without a change; null if the sizes differ.</param>
internal sealed class TransformFinder(Picture mine, Picture reference, PictureDifference? before, PictureJudge judge)
{
    /// <summary>The largest shift that is tried, in pixels.</summary>
    private const int MaxShift = 16;

    private const int SampleCount = 384, Finalists = 6, Edge = 12;

    /// <summary>A reported change leaves at most this percentage of all pixels wrong, and at most one in ten of the wrong ones.</summary>
    private const int Percent = 2, Part = 10;

    private readonly (int X, int Y)[] anywhere = [.. RandomPixels(reference).Take(SampleCount)];

    private readonly (int X, int Y)[] edges = [.. RandomPixels(reference).Skip(SampleCount).Take(50 * SampleCount)
        .Where(pixel => PictureJudge.IsEdge(reference, pixel.X, pixel.Y, Edge)).Take(SampleCount)];

    /// <summary>The simplest change that makes the pictures agree, else the one that nearly does; null if there is none.</summary>
    public Recognition? Find()
    {
        // No transform turns a picture of one colour into one of several.
        if (mine.IsOneColor || reference.IsOneColor) return null;
        var size = (reference.Width, reference.Height);
        var hasItsSize = (mine.Width, mine.Height) == size;
        var hasItsSidesSwapped = (mine.Height, mine.Width) == size;
        var shifts = Enumerable.Range(-MaxShift, 2 * MaxShift + 1).ToArray();
        var candidates =
            from turn in Enum.GetValues<Turn>()
            where TurnedIndices.SwapsSides(turn) ? hasItsSidesSwapped : hasItsSize
            from down in shifts
            from right in shifts
            from channels in (string[])["RGB", "BGR", "GRB", "RBG", "GBR", "BRG"]
            let transform = new PictureTransform(turn, right, down, channels)
            where transform != new PictureTransform()
            let misses = Misses(transform)
            where misses is not null
            orderby misses, transform.Complexity
            select transform;
        IEnumerable<PictureTransform> ofBytes = hasItsSize ? ((int[])[-1, 1, -2, 2, -4, 4]).Select(bytes => new PictureTransform(Bytes: bytes))
            : hasItsSidesSwapped ? [new(SidesSwapped: true)] : [];

        return ofBytes.Concat(candidates.Take(Finalists)).Select(Recognise).Where(IsReported).MinBy(Rank);
    }

    private static IEnumerable<(int X, int Y)> RandomPixels(Picture picture)
    {
        for (var random = new Random(1); ;) yield return (random.Next(picture.Width), random.Next(picture.Height));
    }

    private Recognition Recognise(PictureTransform transform)
    {
        var difference = new PictureDifference(transform.Undo(mine, reference), reference);
        return new(transform, difference, judge.Judge(difference));
    }

    private bool IsReported(Recognition r) =>
        r.Likeness != Likeness.Wrong
        || (r.Difference.Wrong > 0
            && r.Difference.Wrong * 100L <= (long)r.Difference.Pixels * Percent
            && (before is null || (long)r.Difference.Wrong * Part <= before.Wrong));

    private static (bool, int, int) Rank(Recognition r) =>
        (r.Likeness == Likeness.Wrong, r.Likeness == Likeness.Wrong ? r.Difference.Wrong : 0, r.Transform.Complexity);

    /// <summary>How many samples differ after a change; null if they are too many.</summary>
    private int? Misses(PictureTransform transform)
    {
        var pixels = new PixelMapping(transform, mine, reference);
        var onEdges = Misses(pixels, edges, edges.Length * 3 / 5);
        return onEdges is null ? null : onEdges + Misses(pixels, anywhere, anywhere.Length / 20);
    }

    private int? Misses(in PixelMapping pixels, (int X, int Y)[] samples, int limit)
    {
        var misses = 0;
        var beside = 0;
        foreach (var (x, y) in samples)
        {
            if (pixels.At(x, y) is not { } changed)
            {
                if (++beside * 2 > samples.Length) return null;
            }
            else if (!PictureJudge.IsNear(changed, reference[x, y]) && ++misses > limit) return null;
        }
        return misses;
    }
}

/// <summary>A change that makes a wrong picture agree with the right one, or nearly so.</summary>
/// <param name="Likeness">The verdict on the remaining difference; <see cref="Likeness.Wrong"/> if the pictures only nearly agree.</param>
internal sealed record Recognition(PictureTransform Transform, PictureDifference Difference, Likeness Likeness);
