namespace RayCaster.Teaching;

/// <summary>
/// Separates pixels on outlines from wrong pixels by the scene. A pixel may show what a ray a thousandth of a pixel beside it would show, and any
/// of several models at the same distance. If that is too much work, <see cref="PictureOutlines"/> decides.
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

    /// <inheritdoc cref="PictureOutlines.HoldAllWrong"/>
    public bool HoldAllWrong(PictureDifference difference)
    {
        if (!CanJudge(difference.Wrong)) return PictureOutlines.HoldAllWrong(difference);
        var width = difference.Mine.Width;
        for (var i = 0; i < difference.Pixels; i++)
            if (difference.LevelsAt(i) > 1 && !MayShow(difference.Mine[i % width, i / width], i % width, i / width)) return false;
        return true;
    }

    /// <summary>Whether the work for so many pixels is small enough.</summary>
    public bool CanJudge(long pixels) => pixels * 9 * (1 + scene.ShapeCount) <= MostWork;

    /// <summary>Whether another right program may show a colour in a pixel.</summary>
    public bool MayShow((byte R, byte G, byte B) color, int x, int y)
    {
        var crossings = new double[scene.Models.Count];
        for (var down = -1; down <= 1; down++)
            for (var right = -1; right <= 1; right++)
            {
                var nearest = Cross(x + right * Nudge, scene.Camera.Height - 1 - y - down * Nudge, crossings);
                if (double.IsPositiveInfinity(nearest) && IsNear(color, scene.Background)) return true;
                for (var i = 0; i < crossings.Length; i++)
                    if (crossings[i] <= nearest * (1 + Tie) && !double.IsPositiveInfinity(crossings[i])
                        && IsNear(color, scene.Shade(crossings[i], scene.Models[i])))
                        return true;
            }
        return false;
    }

    /// <summary>The t at which the ray through a place in the picture hits each model; +∞ for no hit.</summary>
    /// <returns>The least of them.</returns>
    private double Cross(double column, double row, double[] crossings)
    {
        var d = scene.Camera.Direction<Scalar>(column, row);
        var ray = new Ray(scene.Camera.Position, new(d.X, d.Y, d.Z)) { Clip = scene.Camera.ClipRange, ZPerT = scene.Camera.ZPerT(d) };
        var nearest = double.PositiveInfinity;
        for (var i = 0; i < crossings.Length; i++)
            nearest = Math.Min(nearest, crossings[i] = scene.Models[i].Intersect(ray) ?? double.PositiveInfinity);
        return nearest;
    }

    private static bool IsNear((byte, byte, byte) bytes, Color color) => PictureDifference.Levels(bytes, color.ToBytes()) <= 1;
}
