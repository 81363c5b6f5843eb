namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>What programs do differently without being wrong, or nearly so.</summary>
/// <param name="Truncates">255 x for 255 x + 0.5.</param>
/// <param name="OtherSample">Rays pass through centres where the scene says corners, through corners where it says centres.</param>
/// <param name="Float">All numbers are in single precision.</param>
internal sealed record Manner(bool Truncates = false, bool OtherSample = false, bool Float = false)
{
    /// <summary>As the slides have it, in doubles.</summary>
    public static readonly Manner OfTheSlides = new();

    /// <summary>What it changes in the lab's source, besides the precision.</summary>
    public IEnumerable<Edit> Edits =>
        (Truncates ? Mistake.Named("round").Edits : []).Concat(OtherSample ? Mistake.Named("center").Edits : []);

    /// <summary>What it does differently, in a word or more.</summary>
    public override string ToString() => this == OfTheSlides
        ? "as the slides"
        : string.Join(
            " ", new[] { Truncates ? "truncates" : "", OtherSample ? "other sample" : "", Float ? "float" : "" }.Where(word => word.Length > 0));
}
