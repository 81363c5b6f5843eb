using System.Runtime.InteropServices;

namespace RayCaster.Page;

/// <summary>What a frame shows; the page uses the same numbers.</summary>
internal enum Layer
{
    Picture,
    Map,
    Mine, // the user's own picture
    Difference, // of the two pictures
    ByObject, // the difference, in one colour for each object
}

/// <summary>A picture in the format of a canvas, four bytes for each pixel, so that the page copies nothing.</summary>
internal sealed class CanvasImage(int width, int height)
{
    private readonly byte[] pixels = GC.AllocateUninitializedArray<byte>(4 * width * height);

    /// <summary>The pixels, line 0 at the top.</summary>
    public Memory<byte> Pixels => pixels;

    /// <summary>Six numbers of four bytes, which the server sends before the pixels.</summary>
    /// <param name="number">The count of the page's frames so far.</param>
    /// <param name="isFinal">Whether the camera rests, so that the frame has its full size and no other follows.</param>
    public byte[] Header(Layer layer, int version, int number, bool isFinal) =>
        MemoryMarshal.AsBytes<int>([(int)layer, version, number, isFinal ? 1 : 0, width, height]).ToArray();

    public static CanvasImage Of(Picture picture)
    {
        var frame = new CanvasImage(picture.Width, picture.Height);
        var rgb = picture.Rgb;
        var to = MemoryMarshal.Cast<byte, uint>(frame.pixels.AsSpan());
        for (int i = 0, j = 0; j < to.Length; i += 3, j++) to[j] = 0xFF000000u | (uint)rgb[i + 2] << 16 | (uint)rgb[i + 1] << 8 | rgb[i];
        return frame;
    }
}
