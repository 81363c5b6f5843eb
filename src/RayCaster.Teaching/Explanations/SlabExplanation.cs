namespace RayCaster.Teaching.Explanations;

/// <summary>A slab of a box: the space B0 ≤ coordinate ≤ B1.</summary>
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

    /// <summary>The slabs of a box, by the steps t0 and t1 of its formula; empty for other shapes.</summary>
    public static IReadOnlyList<SlabExplanation> Create(Model shape, Crossings<Derivation> derived)
    {
        if (shape is not Model<Aabb> { Primitive: var (B0, B1) }) return [];
        var steps = NamedValue.LeadingTo(derived.Near).ToLookup(step => step.Name, step => step.Value);
        if ((steps["t0"].ToArray(), steps["t1"].ToArray()) is not
            ([double x0, double y0, double z0], [double x1, double y1, double z1])) return [];
        SlabExplanation[] slabs = [new('x', B0.X, B1.X, x0, x1), new('y', B0.Y, B1.Y, y0, y1), new('z', B0.Z, B1.Z, z0, z1)];
        var last = slabs.MaxBy(slab => slab.Enters);
        var first = slabs.MinBy(slab => slab.Leaves);
        return Array.ConvertAll(slabs, slab => slab with { DecidesEntry = slab == last, DecidesExit = slab == first });
    }
}
