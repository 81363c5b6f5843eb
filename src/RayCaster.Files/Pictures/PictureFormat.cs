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

/// <summary>Chooses a <see cref="PictureFormat"/>.</summary>
public static class PictureFormats
{
    /// <summary>The format that a file's extension names: .png or .ppm, in any case.</summary>
    /// <exception cref="ProblemException">Another extension, or none.</exception>
    public static PictureFormat ByExtension(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".png" => PictureFormat.Png,
        ".ppm" => PictureFormat.Ppm,
        "" => throw new ProblemException($"no picture format for '{path}': the name has no extension; use .png or .ppm"),
        var other => throw new ProblemException($"no picture format for '{path}': {other} is not known; use .png or .ppm"),
    };
}
