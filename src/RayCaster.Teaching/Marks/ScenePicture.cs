namespace RayCaster.Teaching;

/// <summary>A student's picture of one scene.</summary>
internal sealed class ScenePicture
{
    /// <summary>How many pixels are looked at, at most.</summary>
    private const int Pixels = 3000;

    /// <param name="picture">The picture. Its size is the scene's, or the scene's with width and height swapped.</param>
    public ScenePicture(MarkedScene of, Picture picture) =>
        (Of, Evidence) = (of, new(of.Scene, of.Right, picture, Pixels, !of.Judge.TooManyModels));

    public MarkedScene Of { get; }

    public Evidence Evidence { get; }

    /// <summary>The share of its pixels that are wrong.</summary>
    public double WrongShare => (double)Evidence.WrongCount / Evidence.PixelCount;
}
