namespace RayCaster.Teaching;

/// <summary>Chooses, from many models, those that matter for a pixel.</summary>
internal static class NearMisses
{
    private const int OfEachKind = 3;

    /// <summary>
    /// The model that shows; the nearest hidden models; the models whose crossings nearly count; and the models that a neighbouring pixel
    /// shows. In the scene's order.
    /// </summary>
    public static IEnumerable<Trial> Of(IReadOnlyList<Trial> trials, int? winner, IReadOnlyList<Neighbour> neighbours, Ray ray, Camera camera)
    {
        var chosen = new HashSet<int>();
        if (winner is { } index) chosen.Add(index);
        chosen.UnionWith(trials.Where(trial => trial.Hit is not null && trial.Index != winner)
            .OrderBy(trial => trial.Hit).Take(OfEachKind).Select(trial => trial.Index));
        chosen.UnionWith(trials.Where(trial => !trial.Outcome.Counts() && !trial.Outcome.IsMiss())
            .OrderBy(trial => Lacking(trial, ray, camera)).Take(OfEachKind).Select(trial => trial.Index));
        foreach (var neighbour in neighbours)
            if (neighbour.Model is { } model) chosen.Add(model);
        return trials.Where(trial => chosen.Contains(trial.Index));
    }

    /// <summary>How far a crossing is from counting.</summary>
    private static double Lacking(Trial trial, Ray ray, Camera camera)
    {
        return Math.Min(Distance(trial.Near), Distance(trial.Far));

        double Distance(double t) => Outcomes.Of(t, ray) switch
        {
            Outcome.Behind => -t,
            Outcome.UnderBias => camera.Bias - t,
            Outcome.BeforeNear => camera.ZNear - t * ray.ZPerT,
            Outcome.BeyondFar => t * ray.ZPerT - camera.ZFar,
            _ => double.PositiveInfinity,
        };
    }
}
