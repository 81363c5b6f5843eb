namespace RayCaster;

/// <summary>
/// Watches the lines of a picture go by and knows at the end whether it looks like a mistake: one single colour, or nothing but background and
/// black. It looks no further than the first pixel that is neither, so a usual picture costs it nothing.
/// </summary>
/// <param name="background">The scene's background.</param>
public sealed class OddPicture(Color background)
{
    private readonly byte[] empty = BytesOf(background);
    private (byte, byte, byte)? only;
    private bool mayBeOneColor = true, mayBeEmpty = true;

    /// <summary>Whether the lines so far are odd.</summary>
    public bool IsOdd => mayBeOneColor || mayBeEmpty;

    /// <summary>Takes the next lines.</summary>
    /// <param name="rgb">Whole lines of red, green and blue.</param>
    public void Take(ReadOnlySpan<byte> rgb)
    {
        if (rgb.IsEmpty) return;
        if (mayBeOneColor)
        {
            only ??= (rgb[0], rgb[1], rgb[2]);
            mayBeOneColor = only == (rgb[0], rgb[1], rgb[2]) && rgb[3..].SequenceEqual(rgb[..^3]); // each pixel is its left neighbour's like
        }
        if (mayBeEmpty) mayBeEmpty = rgb.IndexOfAnyExcept(empty) < 0;
    }

    /// <summary>The bytes of background and black. A mixture of them in one pixel would pass, too; the ledger then finds nothing odd.</summary>
    private static byte[] BytesOf(Color background)
    {
        var (r, g, b) = background.ToBytes();
        return [0, r, g, b];
    }
}
