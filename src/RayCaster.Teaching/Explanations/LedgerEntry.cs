namespace RayCaster.Teaching;

/// <summary>What became of the rays that one model met: each ray is counted once.</summary>
/// <param name="label">What messages call the model.</param>
public sealed class LedgerEntry(string label)
{
    private readonly long[] counts = new long[Outcomes.Count];

    /// <summary>The model's name, or its place in the scene file and its kind.</summary>
    public string Label { get; } = label;

    /// <summary>How many rays came to this.</summary>
    public long this[Outcome outcome] => counts[(int)outcome];

    /// <summary>Rays that hit the model: it shows, or is hidden by a nearer one.</summary>
    public long Hits => this[Outcome.Shows] + this[Outcome.Hidden];

    /// <summary>The greatest z of crossings that are nearer than zNear; −∞ if there are none.</summary>
    public double GreatestBeforeNear { get; private set; } = double.NegativeInfinity;

    /// <summary>The least z of crossings beyond zFar; +∞ if there are none.</summary>
    public double LeastBeyondFar { get; private set; } = double.PositiveInfinity;

    /// <summary>
    /// Why it does not show, if it does not: the commonest outcome, but what crosses it tells more than what passes beside, and a crossing
    /// in front of the camera more than one behind, where half of every plane lies.
    /// </summary>
    public Outcome Reason
    {
        get
        {
            var reason = Commonest(Outcome.UnderBias, Outcome.BeyondFar);
            if (this[Outcome.Behind] > 2 * this[reason]) reason = Outcome.Behind;
            return this[reason] > 0 ? reason : Commonest(Outcome.Outside, Outcome.NoNumber);
        }
    }

    internal void Count(Outcome outcome, double z)
    {
        counts[(int)outcome]++;
        if (outcome == Outcome.BeforeNear) GreatestBeforeNear = Math.Max(GreatestBeforeNear, z);
        if (outcome == Outcome.BeyondFar) LeastBeyondFar = Math.Min(LeastBeyondFar, z);
    }

    internal void Hide()
    {
        counts[(int)Outcome.Shows]--;
        counts[(int)Outcome.Hidden]++;
    }

    /// <summary>The outcome with the most rays, of equal ones the first.</summary>
    private Outcome Commonest(Outcome first, Outcome last)
    {
        var most = first;
        for (var outcome = first + 1; outcome <= last; outcome++)
            if (this[outcome] > this[most])
                most = outcome;
        return most;
    }
}
