using System.Buffers.Binary;

namespace RayCaster.Teaching;

/// <summary>A submission's picture of a scene, or why there is none.</summary>
/// <param name="Picture">The picture; null if there is none that can be judged.</param>
/// <param name="Problem">What is odd about it, in words; null if nothing is.</param>
internal sealed record SubmittedPicture(MarkedScene Scene, Picture? Picture, string? Problem)
{
    /// <summary>A picture file may have so many bytes for each pixel of the scene's picture: a PPM of numbers takes twelve.</summary>
    private const long BytesPerPixel = 40;

    /// <summary>A PNG may promise so many times the scene's pixels before it is read at all.</summary>
    private const long SizeFactor = 16;

    private const int Pixels = 3000;

    /// <summary>Whether its size is the scene's, or the scene's with width and height swapped, as some mistakes do.</summary>
    public bool CanBeJudged => Picture is not null && HasSizeOf(Scene, Picture.Width, Picture.Height);

    /// <summary>What the picture tells, if it can be judged.</summary>
    public Evidence Evidence => field ??= new(Scene.Scene, Scene.Right, Picture!, Pixels, !Scene.Judge.TooManyModels);

    /// <summary>The share of its pixels that are wrong; 1 if it cannot be judged.</summary>
    public double WrongShare => CanBeJudged ? (double)Evidence.WrongCount / Evidence.PixelCount : 1;

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
            if (PngSize(stream) is var (width, height) && (long)width * height > SizeFactor * pixels)
                return new(scene, null, WrongSize(scene, width, height));
            var picture = PictureFile.Read(stream);
            return new(scene, picture, HasSizeOf(scene, picture.Width, picture.Height) ? note : WrongSize(scene, picture.Width, picture.Height));
        }
        catch (PictureFileException e)
        {
            return new(scene, null, $"the picture cannot be read: {e.Message}");
        }
        catch (Exception e) when (PictureFileException.IsCausedByFile(e))
        {
            return new(scene, null, $"the picture cannot be read: {PictureFileException.Reason(e)}");
        }
    }

    private static bool HasSizeOf(MarkedScene scene, int width, int height) =>
        (width, height) == (scene.Right.Width, scene.Right.Height) || (height, width) == (scene.Right.Width, scene.Right.Height);

    private static string WrongSize(MarkedScene scene, int width, int height) =>
        $"the picture is {width} x {height}, not {scene.Right.Width} x {scene.Right.Height} pixels";

    /// <summary>The size in a PNG's header; null for another format.</summary>
    private static (int Width, int Height)? PngSize(Stream stream)
    {
        Span<byte> head = stackalloc byte[24]; // signature, the first chunk's length and name, width, height
        var isPng = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false) == head.Length && head.StartsWith(PngChunk.Signature);
        stream.Position = 0;
        return isPng ? (BinaryPrimitives.ReadInt32BigEndian(head[16..]), BinaryPrimitives.ReadInt32BigEndian(head[20..])) : null;
    }
}
