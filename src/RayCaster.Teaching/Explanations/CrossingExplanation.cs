namespace RayCaster.Teaching;

/// <summary>What becomes of a crossing, and of a model.</summary>
public enum Verdict
{
    /// <summary>This is what the pixel shows.</summary>
    Shows,

    /// <summary>It counts, but another model is nearer, or as near and earlier in the scene.</summary>
    Hidden,

    /// <summary>It counts, but the model's first crossing counts too.</summary>
    NotNeeded,

    /// <summary>It does not count: behind the camera, or clipped away.</summary>
    Refused,

    /// <summary>There is no crossing.</summary>
    Missed,
}

/// <summary>One place where a ray crosses a model, or would cross it.</summary>
/// <param name="T">The ray parameter; NaN where there is no crossing.</param>
/// <param name="Z">What zNear and zFar are compared with.</param>
/// <param name="Verdict">What becomes of it.</param>
/// <param name="Refusal">Why it does not count; <see cref="Refusal.None"/> if it does.</param>
/// <param name="Reason">The verdict's reason in words.</param>
/// <param name="Numbers">How t came about, from the named steps of the formula; empty where it is one of them.</param>
/// <param name="Untested">Where there is no crossing for a test that failed: the t that the test was about, for example that of the circle's
/// plane.</param>
public sealed record CrossingExplanation(
    double T, double Z, Verdict Verdict, Refusal Refusal, string Reason, string Numbers, double? Untested);
