namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>What programs do differently without being wrong, or nearly so.</summary>
/// <param name="Truncates">255 x for 255 x + 0.5.</param>
/// <param name="OtherSample">Rays pass through centres where the scene says corners, through corners where it says centres.</param>
/// <param name="Float">
/// Every number that has a name on the slides (P, W, U, V, w, h, uc, ur, d, a, b, c, t, X, n, u, v …) is rounded to single precision as soon as it
/// is known, and what is compared with zero or with a radius too; a sum of three products is rounded once.
/// </param>
internal sealed record Manner(bool Truncates = false, bool OtherSample = false, bool Float = false)
{
    /// <summary>As the slides have it, in doubles.</summary>
    public static readonly Manner OfTheSlides = new();

    /// <summary>What it does differently, in a word or more.</summary>
    public override string ToString() => this == OfTheSlides
        ? "as the slides"
        : string.Join(
            " ", new[] { Truncates ? "truncates" : "", OtherSample ? "other sample" : "", Float ? "float" : "" }.Where(word => word.Length > 0));
}
