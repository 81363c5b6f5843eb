namespace RayCaster.Files;

/// <summary>Files that should be the parts of one picture: checks them, and joins them.</summary>
/// <remarks>Only the facts of each file are kept in memory: a set may have as many parts as a picture has lines.</remarks>
internal sealed class PartSet
{
    private readonly List<(string Path, PartFacts Facts)> parts = [];
    private readonly List<string> problems = [];
    private readonly List<string> unreadable = [];
    private readonly List<NumberRange> missing = [];

    /// <param name="isChosen">Whether the user named the file, so that it must be a part. Other PNGs, from a folder, are left out if they are
    /// none.</param>
    /// <param name="whole">Whether the pixels are read, too, so that damaged files are found; a damaged part holds no lines.</param>
    public PartSet(IReadOnlyList<string> paths, Predicate<string>? isChosen = null, bool whole = false)
    {
        foreach (var path in paths)
        {
            try
            {
                if (PartFile.FactsOf(path, whole) is { } facts) parts.Add((path, facts));
                else if (isChosen is null || isChosen(path))
                    problems.Add($"{path} is a picture, but does not say which part of which; the command part draws parts");
            }
            catch (ProblemException e)
            {
                unreadable.Add(e.Message);
            }
        }
        parts.Sort(
            (a, b) => a.Facts.Lines.First.CompareTo(b.Facts.Lines.First) is var order and not 0 ? order : string.CompareOrdinal(a.Path, b.Path));
        if (parts.Count == 0) return;
        FindPartsOfOtherPictures();
        if (problems.Count == 0) FindGapsAndOverlaps();
    }

    public int Count => parts.Count;

    /// <summary>The files that are parts, from the top.</summary>
    public IEnumerable<string> Files => parts.Select(part => part.Path);

    /// <summary>Why these files are not the parts of one picture, a line of text for each reason. Missing parts do not count here.</summary>
    public IReadOnlyList<string> Problems => problems;

    /// <summary>The files that cannot be read, and why, a line of text for each. Their lines count as missing.</summary>
    public IReadOnlyList<string> Unreadable => unreadable;

    /// <summary>The lines that no part holds, from the top; of parts without problems.</summary>
    public IReadOnlyList<NumberRange> Missing => missing;

    public (int Width, int Height) Size => (parts[0].Facts.Width, parts[0].Facts.Height);

    /// <summary>Reads the picture of parts without problems and without missing lines, a line at a time.</summary>
    public void Read(Action<ReadOnlySpan<byte>> takeLine)
    {
        foreach (var (path, facts) in parts)
        {
            PartFile.Open(path, (png, found) =>
            {
                if (found != facts) throw new ProblemException("it was replaced in the meantime");
                png.ReadLines(line => takeLine(line));
                return true;
            });
        }
    }

    private void FindPartsOfOtherPictures()
    {
        var (first, mine) = parts[0];
        foreach (var (path, other) in parts)
        {
            if ((other.Width, other.Height) != (mine.Width, mine.Height))
                problems.Add($"{path} belongs to a picture of {other.Width} x {other.Height} pixels, "
                    + $"{first} to one of {mine.Width} x {mine.Height}");
            else if (other.Digest != mine.Digest)
                problems.Add($"{path} shows another scene than {first}: {Short(other)} instead of {Short(mine)}");
            else if (other.Version != mine.Version)
                problems.Add($"{path} was drawn by version {other.Version}, {first} by {mine.Version}");
        }

        static string Short(PartFacts facts) => facts.Digest.Length > 12 ? facts.Digest[..12] + "…" : facts.Digest;
    }

    /// <summary>Finds lines that no part holds, and lines that two parts hold. The latter is a problem even where they are equal.</summary>
    private void FindGapsAndOverlaps()
    {
        var path = ""; // of the part that reaches farthest down so far
        var reach = -1; // its last line
        foreach (var (next, facts) in parts)
        {
            var lines = facts.Lines;
            if (lines.First > reach + 1) missing.Add(new(reach + 1, lines.First - 1));
            if (lines.First <= reach)
                problems.Add($"the lines {new NumberRange(lines.First, Math.Min(reach, lines.Last))} are in {path} and in {next}");
            if (lines.Last > reach) (path, reach) = (next, lines.Last);
        }
        if (reach < Size.Height - 1) missing.Add(new(reach + 1, Size.Height - 1));
    }
}
