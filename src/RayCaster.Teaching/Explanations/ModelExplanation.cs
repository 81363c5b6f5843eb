namespace RayCaster.Teaching;

/// <summary>One model in the explanation of a pixel.</summary>
/// <param name="Trial">Of a mesh the steps and crossings are those of <see cref="Trial.Triangle"/>.</param>
/// <param name="Name">Its name, or its path in the scene file.</param>
/// <param name="Steps">The steps of its formula; empty for a model in plain doubles and ifs, of which only t is known.</param>
/// <param name="Crossings">The crossings, nearest first; if there is none, one entry says why.</param>
/// <param name="Slabs">A box's slabs; empty for other shapes.</param>
/// <param name="Weights">A triangle's barycentric numbers w, u, v, which add up to 1; null for other shapes and for a triangle seen
/// edge-on.</param>
/// <param name="Beside">Which neighbouring pixels show the model, in words; null if none does.</param>
internal sealed record ModelExplanation(Trial Trial, string Name, Outcome Outcome, string Reason,
    IReadOnlyList<FormulaStep> Steps, IReadOnlyList<CrossingExplanation> Crossings, IReadOnlyList<SlabExplanation> Slabs,
    IReadOnlyList<double>? Weights, string? Beside);

/// <summary>One place where a ray crosses a model, or would cross it.</summary>
/// <param name="T">The ray parameter; NaN where there is no crossing.</param>
/// <param name="Z">What zNear and zFar are compared with.</param>
/// <param name="Numbers">How t is computed from the named steps of the formula; empty where it is one of them.</param>
/// <param name="Untested">Where a test of the formula failed: the t that it would give without the test, for example that of the circle's
/// plane.</param>
internal sealed record CrossingExplanation(double T, double Z, Outcome Outcome, string Reason, string Numbers = "", double? Untested = null);

/// <summary>A slab of a box: the space B0 ≤ coordinate ≤ B1. Its properties are its fields in the JSON.</summary>
/// <param name="Axis">x, y or z.</param>
/// <param name="Lo">B0.</param>
/// <param name="Hi">B1.</param>
/// <param name="T0">(B0 − P) / d.</param>
/// <param name="T1">(B1 − P) / d.</param>
internal sealed record SlabExplanation(char Axis, double Lo, double Hi, double T0, double T1)
{
    /// <summary>Whether the ray runs in a face of the slab, where a t is 0 / 0: it is always in that slab.</summary>
    internal bool HoldsRay => double.IsNaN(T0) || double.IsNaN(T1);

    public double Enters => HoldsRay ? double.NegativeInfinity : Math.Min(T0, T1);

    public double Leaves => HoldsRay ? double.PositiveInfinity : Math.Max(T0, T1);

    /// <summary>Whether the ray enters this slab last, so t_min is its.</summary>
    public bool DecidesEntry { get; init; }

    /// <summary>Whether the ray leaves this slab first, so t_max is its.</summary>
    public bool DecidesExit { get; init; }
}
