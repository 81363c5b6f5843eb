namespace RayCaster.Teaching;

/// <summary>
/// Separates pixels on outlines from wrong pixels by the scene. A pixel may show what a ray a thousandth of a pixel beside it would show, and of
/// several models at the same distance each: there the last bits of doubles or floats decide.
/// </summary>
/// <param name="scene">The scene in the pictures' size.</param>
internal sealed class SceneOutlines(Scene scene)
{
    /// <summary>In pixels: more than the error of a program that computes in floats, and much less than a shift by half a pixel.</summary>
    private const double Nudge = 1e-3;

    /// <summary>If t of two models differ by less, relatively, either may show.</summary>
    private const double Tie = 1e-12;

    /// <summary>Rays times shapes, about a second.</summary>
    private const long MostWork = 50_000_000;

    private readonly Lab right = new(scene);

    private readonly Lab[] nudged =
    [
        .. from right in (double[])[-Nudge, Nudge]
           from up in (double[])[-Nudge, Nudge]
           select new Lab(scene, Mistake.Unnamed(lab => lab.Sample.Becomes(sample => (c, r) => sample(c + right, r + up)))),
    ];

    /// <inheritdoc cref="PictureOutlines.HoldAllWrong"/>
    /// <remarks>If that is too much work, <see cref="PictureOutlines"/> decides.</remarks>
    public bool HoldAllWrong(PictureDifference difference) =>
        (1 + scene.ShapeCount) * (1 + nudged.Length) * difference.Wrong > MostWork ? PictureOutlines.HoldAllWrong(difference)
        : Enumerable.Range(0, difference.Pixels).All(i => difference.LevelsAt(i) <= 1 || MayShow(difference.Mine.At(i), i, 1));

    /// <summary>Whether another right program may show a colour in a pixel, by its place in reading order, up to a difference in levels.</summary>
    public bool MayShow((byte R, byte G, byte B) color, int place, int levels) =>
        nudged.Select(lab => lab[place]).Concat(Nearest(place)).Any(shown => PictureDifference.Levels(color, shown) <= levels);

    /// <summary>The colours of all models at the distance of the nearest; the background's where no model is hit.</summary>
    private IEnumerable<(byte R, byte G, byte B)> Nearest(int place)
    {
        var (line, column) = Math.DivRem(place, scene.Camera.Width);
        var ray = scene.Camera.RayThrough(column, scene.Camera.Height - 1 - line);
        var hits = scene.Models.Select(model => (Model: model, T: right.Hit.Do(model, ray.Direction) ?? double.PositiveInfinity)).ToList();
        var nearest = hits.Select(hit => hit.T).DefaultIfEmpty(double.PositiveInfinity).Min();
        return double.IsInfinity(nearest) ? [scene.Background.ToBytes()]
            : hits.Where(hit => hit.T <= nearest * (1 + Tie)).Select(hit => scene.Shade(hit.T, hit.Model).ToBytes());
    }
}
