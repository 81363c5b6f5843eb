using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace RayCaster.Live;

/// <summary>What a frame's pixels are, as the page numbers it.</summary>
internal enum Layer
{
    /// <summary>The scene's picture.</summary>
    Picture,

    /// <summary>A map over it.</summary>
    Map,

    /// <summary>The user's own picture.</summary>
    Mine,

    /// <summary>Where the two differ.</summary>
    Difference,

    /// <summary>The same, each object in one colour.</summary>
    ByObject,
}

/// <summary>A picture as a canvas takes it without a further step: four bytes for each pixel.</summary>
/// <param name="width">Pixels in a line.</param>
/// <param name="height">Lines.</param>
internal sealed class Frame(int width, int height)
{
    private readonly byte[] pixels = GC.AllocateUninitializedArray<byte>(4 * width * height);

    /// <summary>The pixels, line 0 at the top.</summary>
    public ReadOnlyMemory<byte> Pixels => pixels;

    /// <summary>What is sent before the pixels: six numbers of four bytes.</summary>
    /// <param name="layer">What it shows.</param>
    /// <param name="version">Of which state of the scene.</param>
    /// <param name="number">Which frame of its page it is.</param>
    /// <param name="isFinal">Whether it is sharp, and no other follows by itself.</param>
    public byte[] Header(Layer layer, int version, int number, bool isFinal)
    {
        ReadOnlySpan<int> numbers = [(int)layer, version, number, isFinal ? 1 : 0, width, height];
        var header = new byte[4 * numbers.Length];
        for (var i = 0; i < numbers.Length; i++) BinaryPrimitives.WriteInt32LittleEndian(header.AsSpan(4 * i), numbers[i]);
        return header;
    }

    /// <summary>Puts in some lines of red, green and blue.</summary>
    /// <param name="rgb">The bytes.</param>
    /// <param name="firstPixel">The place of their first pixel.</param>
    public Frame Fill(ReadOnlySpan<byte> rgb, int firstPixel = 0)
    {
        var to = MemoryMarshal.Cast<byte, uint>(pixels.AsSpan(4 * firstPixel, rgb.Length / 3 * 4));
        for (int i = 0, j = 0; j < to.Length; i += 3, j++) to[j] = 0xFF000000u | (uint)rgb[i + 2] << 16 | (uint)rgb[i + 1] << 8 | rgb[i];
        return this;
    }

    /// <summary>A frame of a whole picture.</summary>
    public static Frame Of(Picture picture) => new Frame(picture.Width, picture.Height).Fill(picture.Rgb);
}
