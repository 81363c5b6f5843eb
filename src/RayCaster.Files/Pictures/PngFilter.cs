namespace RayCaster.Files;

/// <summary>PNG's filters (ISO/IEC 15948, clause 9): a byte is stored as its difference from a prediction by its neighbours.</summary>
internal static class PngFilter
{
    /// <summary>Turns differences back into bytes, in place.</summary>
    /// <param name="line">The line, after <paramref name="step"/> zeros.</param>
    /// <param name="above">The line above, after as many zeros; all zeros above the first line.</param>
    /// <param name="step">How far a byte is from its left neighbour: the bytes of a pixel, at least 1.</param>
    public static void Undo(int filter, Span<byte> line, ReadOnlySpan<byte> above, int step)
    {
        switch (filter)
        {
            case 0:
                break;
            case 1:
                for (var i = step; i < line.Length; i++) line[i] += line[i - step];
                break;
            case 2:
                for (var i = step; i < line.Length; i++) line[i] += above[i];
                break;
            case 3:
                for (var i = step; i < line.Length; i++) line[i] += (byte)((line[i - step] + above[i]) / 2);
                break;
            case 4:
                for (var i = step; i < line.Length; i++) line[i] += Paeth(line[i - step], above[i], above[i - step]);
                break;
            default:
                throw new ProblemException($"a line has filter {filter}, but there are only 0 to 4");
        }
    }

    /// <summary>The neighbour nearest to left + above − diagonal; of equally near ones the first.</summary>
    private static byte Paeth(int left, int above, int diagonal)
    {
        var guess = left + above - diagonal;
        var (toLeft, toAbove, toDiagonal) = (Math.Abs(guess - left), Math.Abs(guess - above), Math.Abs(guess - diagonal));
        if (toLeft <= toAbove && toLeft <= toDiagonal) return (byte)left;
        return (byte)(toAbove <= toDiagonal ? above : diagonal);
    }
}
