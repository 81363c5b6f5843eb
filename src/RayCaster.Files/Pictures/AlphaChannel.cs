namespace RayCaster.Files;

/// <summary>The alpha of a picture file in which not every pixel is opaque: how much of a pixel a viewer shows, from 0 for
/// nothing to 255 for all of it.</summary>
public sealed class AlphaChannel
{
    internal AlphaChannel(byte[] values) => Values = values;

    /// <summary>The alpha of each pixel, from left to right, then from top to bottom.</summary>
    public IReadOnlyList<byte> Values { get; }
}
