namespace RayCaster.Teaching.Visibility;

/// <summary>
/// Checks the lines of a picture while they are drawn. A picture looks like a mistake if it has one colour, or only the background's and black.
/// The check stops at the third colour, so a usual picture costs nothing.
/// </summary>
public sealed class OddPicture(Color background)
{
    private readonly List<(byte R, byte G, byte B)> seen = new(3);

    /// <summary>Whether the lines so far look like a mistake.</summary>
    public bool IsOdd => seen.Count <= 1 || (seen.Count == 2 && seen.Contains(default) && seen.Contains(background.ToBytes()));

    /// <summary>Takes the next lines.</summary>
    /// <param name="rgb">Whole lines of red, green and blue.</param>
    public void Take(ReadOnlySpan<byte> rgb)
    {
        if (rgb.IsEmpty || seen.Count > 2) return;
        var isOneColor = rgb[3..].SequenceEqual(rgb[..^3]); // each pixel is like its left neighbour
        for (var i = 0; i < (isOneColor ? 3 : rgb.Length) && seen.Count <= 2; i += 3)
        {
            var pixel = (rgb[i], rgb[i + 1], rgb[i + 2]);
            if (!seen.Contains(pixel)) seen.Add(pixel);
        }
    }
}
