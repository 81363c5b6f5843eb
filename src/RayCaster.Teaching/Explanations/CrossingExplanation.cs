namespace RayCaster.Teaching;

/// <summary>One place where a ray crosses a model, or would cross it.</summary>
/// <param name="T">The ray parameter; NaN where there is no crossing.</param>
/// <param name="Z">What zNear and zFar are compared with.</param>
/// <param name="Numbers">How t is computed from the named steps of the formula; empty where it is one of them.</param>
/// <param name="Untested">Where a test of the formula failed: the t that it would give without the test, for example that of the circle's
/// plane.</param>
public sealed record CrossingExplanation(double T, double Z, Outcome Outcome, string Reason, string Numbers, double? Untested);
