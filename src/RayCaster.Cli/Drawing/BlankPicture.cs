namespace RayCaster.Cli;

/// <summary>
/// Checks the lines of a picture while they are drawn. A picture looks like a mistake if it has one colour, or only the background's and black.
/// The check stops at the third colour, so a usual picture costs nothing.
/// </summary>
internal sealed class BlankPicture(Color background)
{
    private readonly List<int> seen = new(3); // colours as red, green and blue in one number

    public bool IsBlank => seen.Count <= 1 || (seen.Count == 2 && seen.Contains(0) && seen.Contains(Packed(background.ToBytes())));

    public void Take(ReadOnlySpan<byte> rgb)
    {
        for (var i = 0; i < rgb.Length && seen.Count <= 2; i += 3)
            if (Packed((rgb[i], rgb[i + 1], rgb[i + 2])) is var pixel && !seen.Contains(pixel)) seen.Add(pixel);
    }

    private static int Packed((byte R, byte G, byte B) color) => color.R << 16 | color.G << 8 | color.B;
}
