namespace RayCaster.Teaching.Comparison;

/// <summary>How a wrong picture shows one model, or the background.</summary>
/// <param name="Model">The model's index in the scene; −1 for the background.</param>
/// <param name="Pixels">How many pixels show it in the scene's own picture.</param>
/// <param name="Wrong">How many of them differ by more than rounding.</param>
internal sealed record ModelDifference(int Model, string Name, int Pixels, int Wrong)
{
    /// <summary>Whether nearly all of its pixels show what the scene without it shows.</summary>
    public bool IsMissing { get; init; }

    /// <summary>Another colour of the model that would give nearly all of its pixels; null for none.</summary>
    public Color? OtherColor { get; init; }

    public bool IsExplained => IsMissing || OtherColor is not null;

    public Color Color { get; init; }

    /// <summary>
    /// What its wrong pixels show instead, the most frequent first: a model's index, or −1 for the background, and the number of pixels whose
    /// colour fits only that.
    /// </summary>
    public IReadOnlyList<(int Model, int Pixels)> Shows { get; init; } = [];

    public double Share => (double)Wrong / Pixels;
}
