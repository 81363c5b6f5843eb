namespace RayCaster.Teaching.Changes;

/// <summary>How many bits each change of a program costs: the likelier people make it, the fewer.</summary>
internal static class Priors
{
    /// <summary>A kind of shape, attenuation or clipping that is not written yet; rays through the other sample point; another right style.
    /// </summary>
    public const double MissingPart = 3, OtherSample = 5, Style = 2;

    /// <summary>A known mistake, and what another variant or wording of it costs more; an edit that has no name.</summary>
    public const double Known = 6, Variant = 0.5, Wording = 1.5, Unknown = 11;

    /// <summary>What a unit of <see cref="Mutation.Cost"/> costs.</summary>
    public const double PerCost = 4;

    /// <summary>A known mistake that fewer people make, and one that is unlikely by what else is known of the program.</summary>
    public const double Rare = 1, Unlikely = 1.5;

    /// <summary>One model that is not drawn, and what several of a kind cost more; another colour of a model.</summary>
    public const double MissingModel = 9, Several = 3, OtherColor = 12;

    /// <summary>Another number in the scene: which one, and its value; the same in place of two mistakes of the camera, of which some pair draws
    /// nearly each angle.</summary>
    public const double NumberOfScene = 16, NumberForTwo = 13.5;

    /// <summary>Another place for all pixels; another value for each; single pixels that are lost.</summary>
    public const double Places = 9, Values = 13, SinglePixels = 12;

    /// <summary>Lines that no loop reached, of the grey that new memory has, or of any colour, which shapes may have.</summary>
    public const double Lines = 8, LinesOfAnyColor = 12;

    /// <summary>No explanation without formulas is shorter.</summary>
    public const double LeastWithoutFormulas = Lines;

    /// <summary>What it is worth to leave half as many pixels unexplained.</summary>
    public const double PerHalf = 8;

    /// <summary>The share of what is wrong that other last bits may leave.</summary>
    public const double Rounding = 0.004;

    /// <summary>Some other program, which may draw anything, for each picture.</summary>
    public const double OtherProgram = 44;

    /// <summary>The most that a program costs that is mentioned where none is named, for each picture.</summary>
    public const double Mentioned = 1.5 * OtherProgram;

    /// <summary>Explanations that are longer by less than this are told as equally likely: the shortest has less than 90 % of the probability.
    /// </summary>
    public const double AsLikely = 3;

    /// <summary>What a difference as of black to white counts, beside a wrong pixel: it decides between equals.</summary>
    public const double PerError = 0.02;

    /// <summary>What lines cost that no loop reached: by chance a formula draws lines of the background, or of what lies behind.</summary>
    public static double BitsOf(UnreachedLines lines) =>
        (lines.Color.R == lines.Color.G && lines.Color.G == lines.Color.B ? Lines : LinesOfAnyColor) + Math.Min(6, lines.Runs - 1);

    /// <summary>The weight of pixels that are wrong, and of others that are off by a level.</summary>
    public static double WeightOf(double wrong, int offByOne) => wrong + PerError * offByOne / 255;

    /// <summary>
    /// The bits of pixels that are left unexplained. Their share of the wrong ones is unknown before, from all down to what other last bits may
    /// leave: each time that it halves is worth the same.
    /// </summary>
    public static double BitsOf(double unexplained, double wrong) =>
        PerHalf * Math.Log2(1 + Math.Min(1, unexplained / Math.Max(1, wrong)) / Rounding);
}
