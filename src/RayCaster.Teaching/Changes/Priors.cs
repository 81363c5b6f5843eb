namespace RayCaster.Teaching.Changes;

/// <summary>How many bits each change of a program costs: the likelier people make it, the fewer.</summary>
internal static class Priors
{
    /// <summary>A kind of shape, attenuation or clipping that is not written yet; rays through the other sample point; another right style.
    /// </summary>
    public const double NotYet = 3, OtherSample = 5, Style = 2;

    /// <summary>A known mistake, and what another variant or wording of it costs more; an edit that has no name.</summary>
    public const double Known = 6, Variant = 0.5, Wording = 1.5, Unknown = 11;

    /// <summary>What a unit of <see cref="Mutant.Cost"/> costs.</summary>
    public const double PerCost = 4;

    /// <summary>A known mistake that fewer people make, and one that is unlikely by what else is known of the program.</summary>
    public const double Rare = 1, Unlikely = 1.5;

    /// <summary>One model that is not drawn; another number in the scene: which one, and its value; the same in place of two mistakes of the
    /// camera, of which some pair draws nearly each angle.</summary>
    public const double MissingModel = 9, NumberOfScene = 16, NumberForTwo = 13.5;

    /// <summary>What it is worth to leave half as many pixels unexplained.</summary>
    public const double PerHalf = 8;

    /// <summary>The share of what is wrong that other last bits may leave.</summary>
    public const double Rounding = 0.004;

    /// <summary>Some other program, which may draw anything, for each picture.</summary>
    public const double OtherProgram = 44;

    /// <summary>Explanations that are longer by less than this are told as equally likely: the shortest has less than 90 % of the probability.
    /// </summary>
    public const double AsLikely = 3;
}
