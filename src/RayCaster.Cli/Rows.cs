namespace RayCaster.Cli;

/// <summary>Which lines of a picture the option --rows asks for, or which frames of a film --only does.</summary>
internal static class Rows
{
    /// <summary>What a value of the option means for a picture of some height.</summary>
    /// <param name="text"><c>0..249</c>: the lines 0 to 249, both included; <c>3/8</c>: the third of eight parts.</param>
    /// <param name="height">Lines of the whole picture.</param>
    /// <param name="what">What they are called.</param>
    /// <param name="of">What they are of.</param>
    /// <exception cref="ProblemException">That is no such text, or the picture has no such lines.</exception>
    public static LineRange Of(string text, int height, string what = "lines", string of = "a picture")
    {
        var whole = LineRange.Whole(height);
        if (text.Split('/') is [var k, var n] && CommandLine.ParseCount(k) is { } part && CommandLine.ParseCount(n) is { } parts && part <= parts)
        {
            if (parts > height) throw new ProblemException($"raycaster: {of} of {height} {what} has no {parts} parts");
            return new((int)((part - 1L) * height / parts), (int)((long)part * height / parts) - 1);
        }
        if (LineRange.Parse(text) is not { } lines)
            throw ProblemException.Usage(
                $"'{text}' says no {what}: write the first and the last as in 0..249, " +
                    $"{(what == "lines" ? "lines counted from the top, " : "")}0 first, or as in 3/8 the third of eight parts");
        if (lines.Last > whole.Last)
            throw new ProblemException($"raycaster: the {what} {lines} are not all there: {of} of {height} {what} has {whole}");
        return lines;
    }

    /// <summary>Refuses what means no lines of any picture, before a scene is read.</summary>
    /// <exception cref="ProblemException">So it is.</exception>
    public static void Check(string text) => Of(text, int.MaxValue);
}
