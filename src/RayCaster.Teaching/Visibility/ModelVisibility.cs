namespace RayCaster.Teaching.Visibility;

/// <summary>The results of the rays for one model. Each ray is counted once.</summary>
public sealed class ModelVisibility(string label) : Tally
{
    /// <summary>The model's name, or its path in the scene file and its kind.</summary>
    internal string Label => label;

    /// <summary>The rays that hit the model; in some of their pixels a nearer model hides it.</summary>
    internal long Hits => this[Outcome.Shows] + this[Outcome.Hidden];

    /// <summary>The greatest z of crossings that are nearer than zNear; −∞ if there are none.</summary>
    internal double GreatestBeforeNear { get; private set; } = double.NegativeInfinity;

    /// <summary>The least z of crossings beyond zFar; +∞ if there are none.</summary>
    internal double LeastBeyondFar { get; private set; } = double.PositiveInfinity;

    /// <summary>
    /// The main reason why the model does not show: the most frequent outcome. Rays that cross it count before rays that miss it, and crossings
    /// in front of the camera before crossings behind it: half of every plane is behind the camera.
    /// </summary>
    public Outcome Reason
    {
        get
        {
            var reason = ((Outcome[])[Outcome.UnderBias, Outcome.BeforeNear, Outcome.BeyondFar]).MaxBy(outcome => this[outcome]);
            if (this[Outcome.Behind] > 2 * this[reason]) reason = Outcome.Behind;
            return this[reason] > 0 ? reason : Outcome.Misses;
        }
    }

    internal void Count(Outcome outcome, double z)
    {
        this[outcome]++;
        if (outcome == Outcome.BeforeNear) GreatestBeforeNear = Math.Max(GreatestBeforeNear, z);
        if (outcome == Outcome.BeyondFar) LeastBeyondFar = Math.Min(LeastBeyondFar, z);
    }
}
