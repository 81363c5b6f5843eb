namespace RayCaster.Teaching;

/// <summary>
/// Separates pixels on outlines from wrong pixels by the scene. A pixel may show what a ray a thousandth of a pixel beside it would show, and the
/// last of several models at the same distance as well as the first: there the last bits of doubles or floats decide.
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

    private readonly Lab[] labs =
    [
        new(scene, Mistake.Unnamed(lab => lab.Better.Is((t, best) => t <= best * (1 + Tie)))),
        .. from right in (double[])[-Nudge, Nudge]
           from up in (double[])[-Nudge, Nudge]
           select new Lab(scene, Mistake.Unnamed(lab => lab.Sample.Becomes(sample => (c, r) => sample(c + right, r + up)))),
    ];

    /// <inheritdoc cref="PictureOutlines.HoldAllWrong"/>
    /// <remarks>If that is too much work, <see cref="PictureOutlines"/> decides.</remarks>
    public bool HoldAllWrong(PictureDifference difference) =>
        (1 + scene.ShapeCount) * labs.Length * difference.Wrong > MostWork ? PictureOutlines.HoldAllWrong(difference)
        : Enumerable.Range(0, difference.Pixels).All(i => difference.LevelsAt(i) <= 1 || MayShow(difference.Mine.At(i), i, 1));

    /// <summary>Whether another right program may show a colour in a pixel, by its place in reading order, up to a difference in levels.</summary>
    public bool MayShow((byte R, byte G, byte B) color, int place, int levels) =>
        Array.Exists(labs, lab => PictureDifference.Levels(color, lab[place]) <= levels);
}
