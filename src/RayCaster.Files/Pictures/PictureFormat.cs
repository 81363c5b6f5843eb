namespace RayCaster.Files;

/// <summary>The formats that <see cref="PictureWriter"/> writes.</summary>
public enum PictureFormat
{
    /// <summary>PNG: compressed without loss, 8 bits each of red, green and blue.</summary>
    Png,

    /// <summary>PPM in bytes (P6): a header of three lines, then the bytes of the pixels.</summary>
    Ppm,

    /// <summary>PPM in text (P3), which a person can read. It has the extension of P6, so no extension chooses it.</summary>
    PpmText,
}
