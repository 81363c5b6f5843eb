namespace RayCaster.Teaching;

/// <summary>A submission's picture of a scene, or why there is none.</summary>
/// <param name="Picture">The picture; null if there is none that can be judged.</param>
/// <param name="Problem">What is odd about it, in words; null if nothing is.</param>
internal sealed record SubmittedPicture(MarkedScene Scene, Picture? Picture, string? Problem)
{
    /// <summary>A picture file may have so many bytes for each pixel of the scene's picture: a PPM of numbers takes twelve.</summary>
    private const long BytesPerPixel = 40;

    /// <summary>A picture that promises more than so many times the scene's pixels is not read.</summary>
    private const long SizeFactor = 16;

    private const int Pixels = 3000;

    private const double SingleShare = 0.01;

    /// <summary>Whether its size is the scene's, or the scene's with width and height swapped, as some mistakes do.</summary>
    public bool CanBeJudged => Picture is not null && HasSizeOf(Scene, Picture);

    /// <summary>Whether it is the right picture of another scene, the one whose variation was to be drawn, but for single pixels.</summary>
    public bool IsCopied => CanBeJudged && Scene.Known is { } known && known.Width == Picture!.Width && !Evidence.IsRight
        && new PictureDifference(Picture, known) is var difference && difference.Wrong < SingleShare * difference.Pixels;

    /// <summary>Whether it is what the hand-out draws before anything is written: the place of each pixel as a colour.</summary>
    public bool IsUntouched => CanBeJudged && Picture is { } own && Enumerable.Range(0, own.Count).All(i => PictureJudge.IsNear(own.At(i),
        new Color((double)(i % own.Width) / own.Width, (double)(own.Height - 1 - i / own.Width) / own.Height, 0.5).ToBytes()));

    /// <summary>What the picture tells, if it can be judged.</summary>
    public Evidence Evidence => field ??= new(Scene.Scene, Scene.Right, Picture!, Pixels, !Scene.Judge.TooManyModels);

    /// <summary>Reads an untrusted picture file.</summary>
    /// <param name="note">A problem with the run of the program; null for none.</param>
    public static SubmittedPicture Read(MarkedScene scene, string path, string? note = null)
    {
        try
        {
            var file = new FileInfo(path);
            if (!file.Exists) return new(scene, null, note ?? "no picture");
            if (file.LinkTarget is not null) return new(scene, null, "the picture is a link to another file");
            if (file.Length == 0) return new(scene, null, note ?? "the picture file is empty"); // a pipe has no length either
            var pixels = (long)scene.Right.Width * scene.Right.Height;
            if (file.Length > 65_536 + BytesPerPixel * pixels)
                return new(scene, null,
                    FormattableString.Invariant($"the picture file has {file.Length:N0} bytes, too many for the scene's {pixels:N0} pixels"));
            using var stream = file.OpenRead();
            var picture = PictureFile.Read(stream, 3 * SizeFactor * pixels);
            return new(scene, picture, HasSizeOf(scene, picture) ? note
                : $"the picture is {picture.Width} x {picture.Height}, not {scene.Right.Width} x {scene.Right.Height} pixels");
        }
        catch (ProblemException e)
        {
            return new(scene, null, $"the picture cannot be read: {e.Message}");
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            return new(scene, null, $"the picture cannot be read: {ProblemException.Reason(e)}");
        }
    }

    private static bool HasSizeOf(MarkedScene scene, Picture picture) => (picture.Width, picture.Height) is var (width, height)
        && ((width, height) == (scene.Right.Width, scene.Right.Height) || (height, width) == (scene.Right.Width, scene.Right.Height));
}
