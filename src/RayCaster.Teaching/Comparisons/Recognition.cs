namespace RayCaster.Teaching;

/// <summary>A change that makes a wrong picture agree with the right one, or nearly so.</summary>
/// <param name="Likeness">The verdict on the remaining difference; <see cref="Likeness.Wrong"/> if the pictures only nearly agree.</param>
internal sealed record Recognition(Change Change, PictureDifference Difference, Likeness Likeness);
