namespace RayCaster.Teaching.Explanations;

/// <summary>The result of a ray for a model, or for one of its crossings.</summary>
public enum Outcome
{
    /// <summary>It counts, and the pixel shows it.</summary>
    Shows,

    /// <summary>It counts, but another model is nearer; or as near, and earlier in the scene.</summary>
    Hidden,

    /// <summary>It counts, but the model's first crossing counts too.</summary>
    NotNeeded,

    /// <summary>t &lt; 0: behind the camera.</summary>
    Behind,

    /// <summary>0 ≤ t ≤ bias: too near to where the ray starts.</summary>
    UnderBias,

    /// <summary>z &lt; zNear.</summary>
    BeforeNear,

    /// <summary>z &gt; zFar.</summary>
    BeyondFar,

    /// <summary>No crossing: the formula gives NaN or infinity.</summary>
    Misses,
}

/// <summary>Decides which crossings count.</summary>
internal static class Outcomes
{
    /// <summary>Why a crossing does not count; <see cref="Outcome.Shows"/> if it does, whatever else is in the scene.</summary>
    /// <param name="t">The crossing; NaN or infinite for none.</param>
    public static Outcome Classify(double t, Ray ray) =>
        !double.IsFinite(t) ? Outcome.Misses
        : t < 0 ? Outcome.Behind
        : !ray.ClipRange.IsAhead<Scalar>(t).Holds ? Outcome.UnderBias
        : !ray.ClipRange.IsBeyondNear<Scalar>(t * ray.DepthPerT).Holds ? Outcome.BeforeNear
        : ray.ClipRange.IsWithinFar<Scalar>(t * ray.DepthPerT).Holds ? Outcome.Shows
        : Outcome.BeyondFar;

    public static bool Counts(this Outcome outcome) => outcome <= Outcome.NotNeeded;
}

/// <summary>An outcome in words.</summary>
/// <param name="Title">Of a column.</param>
/// <param name="Place">Where a model lies that has it.</param>
/// <param name="One">What a model does that has it for each ray; empty for those that are hit.</param>
/// <param name="Many">What several models do.</param>
internal sealed record OutcomeText(Outcome Outcome, string Title, string Place, string One = "", string Many = "")
{
    public static readonly OutcomeText[] All =
    [
        new(Outcome.Shows, "shows", ""),
        new(Outcome.Hidden, "hidden", "hidden by nearer models"),
        new(Outcome.Behind, "behind", "behind the camera", "lies behind the camera", "lie behind the camera"),
        new(Outcome.UnderBias, "t <= bias", "nearer than bias", "is crossed only at t <= bias", "are crossed only at t <= bias"),
        new(Outcome.BeforeNear, "z < zNear", "nearer than zNear", "lies nearer than zNear", "lie nearer than zNear"),
        new(Outcome.BeyondFar, "z > zFar", "beyond zFar", "lies beyond zFar", "lie beyond zFar"),
        new(Outcome.Misses, "misses", "missed", "is missed by every ray", "are missed by every ray"),
    ];

    public static OutcomeText Find(Outcome outcome) => All.First(text => text.Outcome == outcome);
}

/// <summary>How many models, triangles or rays have each outcome.</summary>
public class Tally
{
    private readonly long[] counts = new long[(int)Outcome.Misses + 1];

    /// <summary>The number of those with an outcome.</summary>
    public long this[Outcome outcome]
    {
        get => counts[(int)outcome];
        internal set => counts[(int)outcome] = value;
    }

    internal long Total => counts.Sum();
}
