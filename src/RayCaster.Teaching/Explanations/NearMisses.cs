namespace RayCaster.Teaching;

/// <summary>Chooses, from many models, those that matter for a pixel.</summary>
internal static class NearMisses
{
    private const int OfEachKind = 3;

    /// <summary>
    /// The model that shows; the nearest hidden models; the models whose crossings nearly count; and the models that a neighbouring pixel
    /// shows. In the scene's order.
    /// </summary>
    public static IReadOnlyList<Trial> Of(PixelExplanation pixel)
    {
        var hidden = pixel.Trials.Where(trial => trial.Hit is not null && trial.Index != pixel.Winner).OrderBy(trial => trial.Hit);
        var refused = pixel.Trials.Where(trial => !trial.Outcome.Counts() && !trial.Outcome.IsMiss()).OrderBy(trial => Lacking(trial, pixel));
        HashSet<int?> chosen =
        [
            pixel.Winner,
            .. pixel.Neighbours.Select(neighbour => neighbour.Model),
            .. hidden.Take(OfEachKind).Concat(refused.Take(OfEachKind)).Select(trial => (int?)trial.Index),
        ];
        return [.. pixel.Trials.Where(trial => chosen.Contains(trial.Index))];
    }

    /// <summary>How far a crossing is from counting.</summary>
    private static double Lacking(Trial trial, PixelExplanation pixel)
    {
        var (t, z, camera) = (trial.T, trial.T * pixel.Ray.ZPerT, pixel.Scene.Camera);
        return trial.Outcome switch
        {
            Outcome.Behind => -t,
            Outcome.UnderBias => camera.Bias - t,
            Outcome.BeforeNear => camera.ZNear - z,
            _ => z - camera.ZFar,
        };
    }
}
