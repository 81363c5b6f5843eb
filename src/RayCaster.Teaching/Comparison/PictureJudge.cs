namespace RayCaster.Teaching.Comparison;

/// <summary>
/// Judges whether a picture is the right one: no channel differs by more than 1 of 255 levels, and at most 1 % of the pixels differ by that, as
/// rounding makes them. Pixels on outlines are left out: there the last bits of doubles or floats decide which side shows.
/// </summary>
/// <param name="reference">The right picture.</param>
/// <param name="scene">Its scene, in its size: rays find the outlines. Without it, or where that takes too long, the pictures do.</param>
public sealed class PictureJudge(Picture reference, Scene? scene = null)
{
    /// <summary>By how many levels a channel may differ.</summary>
    public const int Tolerance = 1;

    /// <summary>The share of the pixels that rounding may change by a level.</summary>
    internal const double Rounded = 0.01;

    /// <summary>In pixels: more than the error of a program that computes in floats, and much less than a shift by half a pixel.</summary>
    private const double Nudge = 1e-3;

    /// <summary>If t of two models differ by less, relatively, either may show.</summary>
    private const double Tie = 1e-12;

    /// <summary>Rays times shapes, about a second.</summary>
    private const long MaxWork = 50_000_000;

    /// <summary>How many pixels, and which share of them, may show the other side of an outline that is farther away.</summary>
    private const int MaxStray = 3;

    private const double MaxStrayShare = 1e-4;

    /// <summary>By how many levels pixels beside each other may differ on one model, because of the attenuation.</summary>
    private const int Shading = 2;

    /// <summary>Without rays, one in so many pixels may show the other side of an outline: a shift by half a pixel changes about half.</summary>
    private const int Rarity = 20;

    private static readonly (double Right, double Up)[] rays = [(0, 0), (-Nudge, -Nudge), (-Nudge, Nudge), (Nudge, -Nudge), (Nudge, Nudge)];

    /// <summary>The verdict on a picture; one of another size is wrong.</summary>
    public Likeness Compare(Picture mine) =>
        (mine.Width, mine.Height) == (reference.Width, reference.Height) ? Compare(new PictureDifference(mine, reference)) : Likeness.Wrong;

    /// <param name="difference">That of the picture in question to the right one.</param>
    internal Likeness Compare(PictureDifference difference) =>
        difference.Largest == 0 ? Likeness.Identical
        : difference.Wrong > 0 && !AreStray(difference, WrongPixels(difference)) ? Likeness.Wrong
        : difference.OffByOne > Rounded * difference.Pixels ? Likeness.RoundedOtherwise
        : difference.Wrong == 0 ? Likeness.WithinRounding
        : Likeness.OutlinesOnly;

    /// <summary>The pixels that differ by more than rounding and are not on outlines, by their index in reading order.</summary>
    internal IEnumerable<int> WrongPixels(PictureDifference difference)
    {
        var wrong = Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong);
        if (scene is not null && (1 + scene.ShapeCount) * rays.Length * difference.Wrong <= MaxWork)
            return wrong.Where(i => !ShownBeside(i).Any(shown => IsNear(difference.Mine.At(i), shown)));
        return AreOnThinOutlines(difference) ? [] : wrong;
    }

    /// <summary>Whether wrong pixels are only a few, each showing the other side of an outline: floats move some outlines farther.</summary>
    internal bool AreStray(PictureDifference difference, IEnumerable<int> wrong)
    {
        var most = Math.Max(MaxStray, (int)(MaxStrayShare * difference.Pixels));
        return !wrong.Skip(most).Any()
            && wrong.All(i => ShowsOtherSide(i % reference.Width, i / reference.Width, difference.Mine.At(i)));
    }

    /// <summary>Whether two colours are the same but for rounding.</summary>
    internal static bool IsNear((byte R, byte G, byte B) a, (byte R, byte G, byte B) b) => PictureDifference.Levels(a, b) <= Tolerance;

    /// <summary>Whether a pixel differs from the one to the right or the one below by more than the attenuation explains.</summary>
    private static bool IsEdge(Picture picture, int x, int y) =>
        (x + 1 < picture.Width && PictureDifference.Levels(picture[x, y], picture[x + 1, y]) > Shading)
        || (y + 1 < picture.Height && PictureDifference.Levels(picture[x, y], picture[x, y + 1]) > Shading);

    /// <summary>What rays through a pixel and a thousandth of a pixel beside it show, of several models at the same distance each.</summary>
    private IEnumerable<(byte R, byte G, byte B)> ShownBeside(int pixel)
    {
        var (line, column) = Math.DivRem(pixel, reference.Width);
        var camera = scene!.Camera;
        foreach (var (right, up) in rays)
        {
            var d = camera.Direction<Scalar>(column + right, camera.Height - 1 - line + up);
            var ray = new Ray(camera.Position, new(d.X, d.Y, d.Z)) { ClipRange = camera.ClipRange, DepthPerT = camera.DepthPerT(d) };
            var hits = scene.Models.Select((model, i) => new Hit(model.Intersect(ray) ?? double.PositiveInfinity, i)).ToList();
            var nearest = hits.Select(hit => hit.T).DefaultIfEmpty(double.PositiveInfinity).Min();
            if (double.IsInfinity(nearest)) yield return scene.Background.ToBytes();
            else foreach (var hit in hits.Where(hit => hit.T <= nearest * (1 + Tie))) yield return scene.Shade(hit).ToBytes();
        }
    }

    /// <summary>Whether the wrong pixels show the other side of an outline, in thin lines and on a small part of all outlines.</summary>
    private bool AreOnThinOutlines(PictureDifference difference)
    {
        var (width, height) = (reference.Width, reference.Height);
        if (difference.Wrong > difference.Pixels / Rarity) return false;
        var outlines = 0;
        for (var y = 0; y < height; y++)
        {
            for (var x = 0; x < width; x++)
            {
                if (IsEdge(reference, x, y)) outlines++;
                if (IsWrong(x, y) && (IsThick(x, y) || !ShowsOtherSide(x, y, difference.Mine[x, y]))) return false;
            }
        }
        return (difference.Wrong - 1) * Rarity < outlines;

        bool IsWrong(int x, int y) => x < width && y < height && difference.IsWrong(y * width + x);

        bool IsThick(int x, int y) => IsWrong(x + 1, y) && IsWrong(x, y + 1) && IsWrong(x + 1, y + 1); // the upper left one of four
    }

    /// <summary>Whether one of the eight neighbours lies across an outline and has a colour, but for its attenuation.</summary>
    private bool ShowsOtherSide(int x, int y, (byte R, byte G, byte B) color)
    {
        for (var j = Math.Max(0, y - 1); j <= Math.Min(reference.Height - 1, y + 1); j++)
            for (var i = Math.Max(0, x - 1); i <= Math.Min(reference.Width - 1, x + 1); i++)
                if (PictureDifference.Levels(reference[i, j], reference[x, y]) > Shading
                    && PictureDifference.Levels(reference[i, j], color) <= Shading) return true;
        return false;
    }
}
