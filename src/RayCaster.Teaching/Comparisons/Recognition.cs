namespace RayCaster.Teaching;

/// <summary>A change that makes a wrong picture agree with the right one, or nearly so.</summary>
/// <param name="Change">What must be done to the picture.</param>
/// <param name="Difference">What then is left.</param>
/// <param name="Likeness">The verdict on what is left; <see cref="Likeness.Wrong"/> if it agrees only nearly.</param>
public sealed record Recognition(Change Change, PictureDifference Difference, Likeness Likeness)
{
    /// <summary>Of a hundred pixels so many may be left wrong, and one in ten of those that were.</summary>
    private const int Percent = 2, Part = 10;

    /// <summary>Whether it is to be told.</summary>
    /// <param name="before">The difference without the change; null where there is none, for the sizes differ.</param>
    internal bool IsWorthTelling(PictureDifference? before) =>
        Likeness != Likeness.Wrong
        || (Difference.Wrong > 0
            && (long)Difference.Wrong * 100 <= (long)Difference.Pixels * Percent
            && (before is null || (long)Difference.Wrong * Part <= before.Wrong));
}
