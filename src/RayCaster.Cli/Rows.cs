namespace RayCaster.Cli;

/// <summary>Parses the lines of --rows and the frames of --only.</summary>
internal static class Rows
{
    /// <summary>The lines of a picture that a value stands for.</summary>
    /// <param name="text"><c>0..249</c>: the lines 0 to 249, both included; <c>3/8</c>: the third of eight parts.</param>
    /// <param name="what">Their name in messages: lines or frames.</param>
    /// <param name="of">What has them, in messages: a picture or a film.</param>
    /// <exception cref="ProblemException">The value has another form, or the picture has no such lines.</exception>
    public static LineRange Of(string text, int height, string what = "lines", string of = "a picture")
    {
        var whole = LineRange.Whole(height);
        if (text.Split('/') is [var k, var n] && CommandLine.ParseCount(k) is { } part && CommandLine.ParseCount(n) is { } parts && part <= parts)
        {
            if (parts > height) throw new ProblemException($"raycaster: {of} of {height} {what} cannot be divided into {parts} parts");
            return new((int)((part - 1L) * height / parts), (int)((long)part * height / parts) - 1);
        }
        if (LineRange.Parse(text) is not { } lines)
            throw ProblemException.Usage(
                $"'{text}' names no {what}: write the first and the last as in 0..249, " +
                    $"counted from 0{(what == "lines" ? " at the top" : "")}, or 3/8 for the third of eight parts");
        if (lines.Last > whole.Last)
            throw new ProblemException($"raycaster: the {what} {lines} do not all exist: {of} of {height} {what} has {whole}");
        return lines;
    }
}
