using System.Security.Cryptography;

namespace RayCaster.Marks;

/// <summary>A student's picture of a scene, or why there is none.</summary>
/// <param name="Picture">The picture; null if there is none that can be judged.</param>
/// <param name="Problem">What is odd about it, in words, in which <see cref="Submission.Name"/> stands for the scene; null if nothing is.</param>
internal sealed record SubmittedPicture(MarkedScene Scene, Picture? Picture, string? Problem)
{
    /// <summary>A picture file may have so many bytes for each pixel of the scene's picture: a PPM of numbers takes twelve.</summary>
    private const long BytesPerPixel = 40;

    /// <summary>A picture that promises more than so many times the scene's pixels is not read.</summary>
    private const long SizeFactor = 16;

    /// <summary>Whether it has a size in which it can be judged (<see cref="Diagnoser.CanJudge"/>).</summary>
    public bool CanBeJudged => Picture is not null && Diagnoser.CanJudge(Scene.Scene, Picture);

    /// <summary>Whether it is what the hand-out draws before anything is written.</summary>
    public bool IsUntouched => CanBeJudged && Picture!.Width == Scene.Right.Width
        && new PictureDifference(Picture, LabSteps.Draw(Scene.Scene, 1)).Largest <= PictureJudge.Tolerance;

    /// <summary>A hash of its size and bytes, if there is a picture.</summary>
    public string Digest => field ??= $"{Picture!.Width} {Convert.ToHexStringLower(SHA256.HashData(Picture.Rgb))}";

    /// <summary>The problem in words, of this scene's picture or of those of several scenes.</summary>
    public string? ProblemOf(bool several = false) => Problem?.Replace(Submission.Name, several ? "SCENE" : Scene.Name);

    /// <summary>Reads an untrusted picture file.</summary>
    public static SubmittedPicture Read(MarkedScene scene, string path)
    {
        try
        {
            var file = new FileInfo(path);
            if (file.Length == 0) return new(scene, null, "the picture file is empty"); // a pipe has no length either
            var pixels = (long)scene.Right.Width * scene.Right.Height;
            if (file.Length > 65_536 + BytesPerPixel * pixels)
                return new(scene, null,
                    FormattableString.Invariant($"the picture file has {file.Length:N0} bytes, too many for the scene's {pixels:N0} pixels"));
            using var stream = file.OpenRead();
            var picture = PictureFile.Read(stream, 3 * SizeFactor * pixels);
            return new(scene, picture, Diagnoser.CanJudge(scene.Scene, picture) ? null
                : $"the picture is {picture.Width} x {picture.Height}, not {scene.Right.Width} x {scene.Right.Height} pixels");
        }
        catch (Exception e) when (e is ProblemException || ProblemException.IsCausedByFile(e))
        {
            return new(scene, null, $"the picture cannot be read: {(e is ProblemException ? e.Message : ProblemException.Reason(e))}");
        }
    }
}
