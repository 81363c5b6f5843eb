namespace RayCaster.Teaching.Formulas;

/// <summary>The hits of a part.</summary>
/// <param name="T">The first t that counts, in each pixel; NaN where none does.</param>
internal readonly record struct PartHits(double[] T)
{
    /// <summary>Whether there is a hit, where a t of NaN may be one.</summary>
    public double[]? IsHit { get; init; }

    /// <summary>The second t, where it counts, too.</summary>
    public double[]? Far { get; init; }

    /// <summary>Whether the ray ends here with the background.</summary>
    public PixelValues? Ends { get; init; }

    /// <summary>The same in arrays of its own.</summary>
    public PartHits Copy() => new([.. T])
    {
        IsHit = IsHit is null ? null : [.. IsHit],
        Far = Far is null ? null : [.. Far],
        Ends = Ends?.Copy(),
    };

    /// <summary>Puts in each pixel the lesser of two t, of which NaN is none.</summary>
    public static void Offer(double[] nearest, double[] t)
    {
        for (var i = 0; i < t.Length; i++)
            if (!(nearest[i] <= t[i])) nearest[i] = double.IsNaN(t[i]) ? nearest[i] : t[i];
    }
}
