namespace RayCaster.Teaching.Diagnosis;

/// <summary>The result of a diagnosis.</summary>
public enum DiagnosisKind
{
    /// <summary>The picture is the scene's, but for rounding and single pixels on outlines.</summary>
    Matches,

    /// <summary>The picture is a part of the scene's: lines or columns at its border are missing.</summary>
    Cropped,

    /// <summary>Some kinds of shape are not drawn yet, and what is drawn is right.</summary>
    Unfinished,

    /// <summary>One mistake of the catalogue, or two, explain the picture; some kinds of shape may be missing besides.</summary>
    Mistake,

    /// <summary>The picture is wrong, and no mistake of the catalogue explains it.</summary>
    NoneOfThese,

    /// <summary>The formulas are right, as far as the picture shows: some pixels were never drawn.</summary>
    NotTheFormulas,

    /// <summary>Nothing but background, one colour, or models that are all black or all white: many mistakes draw such a picture, so none is
    /// named.</summary>
    TellsNothing,
}
