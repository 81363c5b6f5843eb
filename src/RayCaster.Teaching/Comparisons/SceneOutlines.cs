namespace RayCaster.Teaching;

/// <summary>
/// Knows the scene: a pixel may show what it would show if its ray passed a thousandth of a pixel beside, and of several models at the same
/// distance any. Where that is too much work it leaves the judgement to <see cref="PictureOutlines"/>.
/// </summary>
/// <param name="scene">The scene in the pictures' size.</param>
internal sealed class SceneOutlines(Scene scene) : IOutlines
{
    /// <summary>In pixels: a program that computes in floats is less far away, half a pixel's shift is much more.</summary>
    private const double Nudge = 1e-3;

    /// <summary>Parameters that differ by less, relatively, are equal but for their last bits.</summary>
    private const double Tie = 1e-12;

    /// <summary>Rays times shapes, about a second.</summary>
    private const long MostWork = 50_000_000;

    public bool HoldAllWrong(PictureDifference difference)
    {
        if (!CanJudge(difference.Wrong)) return PictureOutlines.Instance.HoldAllWrong(difference);
        var width = difference.Mine.Width;
        for (var i = 0; i < difference.Pixels; i++)
            if (difference.LevelsAt(i) > 1 && !MayShow(difference.Mine[i % width, i / width], i % width, i / width)) return false;
        return true;
    }

    /// <summary>Whether so many pixels are not too much work.</summary>
    public bool CanJudge(long pixels)
    {
        long shapes = 1;
        foreach (var model in scene.Models) shapes += model is Mesh mesh ? mesh.TriangleCount : 1;
        return pixels * 9 * shapes <= MostWork;
    }

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

    /// <summary>Where the ray through a place in the picture meets each model, +∞ for not at all.</summary>
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
