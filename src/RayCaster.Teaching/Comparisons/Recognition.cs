namespace RayCaster.Teaching;

/// <summary>A change that makes a wrong picture agree with the right one, or nearly so.</summary>
/// <param name="Likeness">The verdict on the remaining difference; <see cref="Likeness.Wrong"/> if the pictures only nearly agree.</param>
internal sealed record Recognition(Change Change, PictureDifference Difference, Likeness Likeness)
{
    /// <summary>A reported change leaves at most this percentage of all pixels wrong, and at most one in ten of the wrong ones.</summary>
    private const int Percent = 2, Part = 10;

    /// <param name="before">The difference without the change; null if the sizes differ.</param>
    internal bool IsReported(PictureDifference? before) =>
        Likeness != Likeness.Wrong
        || (Difference.Wrong > 0
            && (long)Difference.Wrong * 100 <= (long)Difference.Pixels * Percent
            && (before is null || (long)Difference.Wrong * Part <= before.Wrong));
}
