namespace RayCaster.Files;

/// <summary>PNGs that hold some lines of a picture (<see cref="PartFacts"/>).</summary>
internal static class PartFile
{
    /// <summary>Which lines of which picture a file holds; null for a PNG that is no part.</summary>
    /// <param name="whole">Whether its pixels are read, too, so that a damaged file is refused.</param>
    internal static PartFacts? FactsOf(string path, bool whole = false) => Open(path, (png, facts) =>
    {
        if (whole && facts is not null) png.ReadLines(_ => { });
        return facts;
    });

    /// <summary>Whether a file exists, can be read to its last pixel, and holds these lines of this picture.</summary>
    /// <param name="reason">Why not, as the end of a sentence; null if there is no file.</param>
    public static bool Holds(string path, PartFacts facts, out string? reason)
    {
        reason = null;
        if (!File.Exists(path)) return false;
        try
        {
            reason = Open(path, (png, found) => WhyNot(png, found, facts));
        }
        catch (ProblemException e)
        {
            reason = e.Message;
        }
        return reason is null;
    }

    internal static T Open<T>(string path, Func<PngReader, PartFacts?, T> read) => PictureFile.Open(path, file =>
    {
        var png = new PngReader(file, 3 * Camera.MaxPixels, keyword: PartFacts.Keyword);
        return read(png, FactsOf(png));
    });

    private static string? WhyNot(PngReader png, PartFacts? found, PartFacts wanted)
    {
        if (found is null) return "it does not say which scene it shows; only parts and the frames of an orbit do";
        if (found.Version != wanted.Version) return $"it was drawn by version {found.Version}, and this is {wanted.Version}";
        if (found != wanted) return "it shows another scene, another size or other lines";
        png.ReadLines(_ => { }); // a damaged one is drawn again
        return null;
    }

    private static PartFacts? FactsOf(PngReader png)
    {
        if (png.Text is not { } text) return null;
        if (PartFacts.Parse(text) is not { } facts)
            throw new ProblemException("its text about its part of the picture is unknown; perhaps a newer raycaster drew it");
        if ((png.Header.Width, png.Header.Height) != (facts.Width, facts.Lines.Count))
            throw new ProblemException($"it says that it holds the lines {facts.Lines}, each of {facts.Width} pixels, "
                + $"but has {png.Header.Height} lines of {png.Header.Width}: it was changed by another program");
        return facts;
    }
}
