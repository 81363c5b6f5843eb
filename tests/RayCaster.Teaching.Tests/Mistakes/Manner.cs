namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>What programs do differently without being wrong, or nearly so.</summary>
/// <param name="Truncates">255 x for 255 x + 0.5.</param>
/// <param name="OtherSample">Rays pass through centres where the scene says corners, through corners where it says centres.</param>
/// <param name="Float">All numbers are in single precision.</param>
/// <param name="OtherFormulas">Pythagoras for the sphere, Möller–Trumbore for the triangle.</param>
internal sealed record Manner(bool Truncates = false, bool OtherSample = false, bool Float = false, bool OtherFormulas = false)
{
    /// <summary>As the slides have it, in doubles.</summary>
    public static readonly Manner OfTheSlides = new();

    private static readonly SourceEdit[] otherFormulas =
    [
        new("Sphere", "D * D > R", "L * L - t_ca * t_ca > R"),
        new("Sphere", "(R * R - D * D)", "(R * R - (L * L - t_ca * t_ca))"),
        SourceEdit.OfTriangle("""
            var (e1, e2, s, d) = (B - A, C - A, ray.Origin - A, ray.Direction);
            var (p, q) = (d % e2, s % e1);
            var det = e1 * p;
            var (u, v, t) = (s * p / det, d * q / det, e2 * q / det);
            if (u >= 0 && v >= 0 && u + v <= 1) ray.Hit(t, this);
            """),
    ];

    /// <summary>What it changes in the lab's source, besides the precision.</summary>
    public IEnumerable<SourceEdit> Edits =>
    [
        .. Truncates ? PlantedMistake.Named("round").Edits : [],
        .. OtherSample ? PlantedMistake.Named("center").Edits : [],
        .. OtherFormulas ? otherFormulas : [],
    ];
}
