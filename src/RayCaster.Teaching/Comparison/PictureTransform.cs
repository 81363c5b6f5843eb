namespace RayCaster.Teaching.Comparison;

/// <summary>A change of the whole picture that makes it agree with the right one.</summary>
/// <param name="Turn">How the picture must be turned or mirrored.</param>
/// <param name="Right">By how many pixels it must be moved to the right after that.</param>
/// <param name="Down">By how many lines it must be moved down.</param>
/// <param name="Channels">The letters of RGB in the order in which its pixels have them.</param>
/// <param name="Bytes">By how many bytes all its bytes must be moved towards the end of the file.</param>
/// <param name="SidesSwapped">Whether its bytes are in the right order, but width and height are swapped.</param>
internal sealed record PictureTransform(
    Turn Turn = Turn.None, int Right = 0, int Down = 0, string Channels = "RGB", int Bytes = 0, bool SidesSwapped = false)
{
    /// <summary>How complex the change is. Of changes with the same effect, the simplest is reported.</summary>
    internal int Complexity =>
        (Turn == Turn.None ? 0 : 100) + (Right == 0 && Down == 0 ? 0 : 100 + Math.Abs(Right) + Math.Abs(Down))
        + (Channels == "RGB" ? 0 : 100) + (Bytes == 0 ? 0 : 100 + Math.Abs(Bytes));

    /// <summary>The change in words, as the beginning of a sentence on the changed picture.</summary>
    public string Description => string.Join(" and ", ((string?[])
    [
        Turn switch
        {
            Turn.None => null,
            Turn.TopBottom => "flipped top to bottom",
            Turn.LeftRight => "mirrored left to right",
            Turn.Half => "turned by 180°",
            Turn.Transposed => "transposed",
            Turn.Clockwise => "turned by 90° clockwise",
            Turn.CounterClockwise => "turned by 90° counter-clockwise",
            _ => "transposed and turned by 180°",
        },
        Right == 0 ? null : $"moved {Digits.Count(Math.Abs(Right), "pixel")} to the {(Right > 0 ? "right" : "left")}",
        Down == 0 ? null : $"moved {Digits.Count(Math.Abs(Down), "line")} {(Down > 0 ? "down" : "up")}",
        Channels == "RGB" ? null : $"read as {Channels}",
        Bytes == 0 ? null : $"with its bytes moved by {Math.Abs(Bytes)} towards the {(Bytes > 0 ? "end" : "beginning")}",
        SidesSwapped ? "with width and height swapped in its header" : null,
    ]).OfType<string>());

    /// <summary>The usual cause of such a picture, as a question.</summary>
    public string Question => this switch
    {
        { SidesSwapped: true } => "does the program write the height first?",
        { Bytes: < 0 } => "does the header end with bytes that do not belong there?",
        { Bytes: > 0 } => "does the program write too few bytes after the header?",
        { Turn: Turn.TopBottom } => "are rows written upside down?",
        { Turn: Turn.LeftRight } => "are columns written from the right?",
        { Turn: Turn.Half } => "are rows and columns both written from the wrong end?",
        { Turn: not Turn.None } => "are rows and columns swapped?",
        { Channels: not "RGB" } => "are red, green and blue written in another order?",
        _ => "does a loop or an index begin too early or too late?",
    };

    /// <summary>
    /// Corrects a picture. A pixel that nothing moves to gets the reference's colour; so does a byte that may come from the right one.
    /// </summary>
    /// <param name="mine">The picture in question; its sides are those of the reference, or swapped where the change swaps them.</param>
    public Picture Undo(Picture mine, Picture reference)
    {
        if (SidesSwapped || Bytes != 0)
        {
            var rgb = (byte[])reference.Rgb.Clone();
            mine.Rgb.AsSpan(Math.Max(0, -Bytes), mine.Rgb.Length - Math.Abs(Bytes)).CopyTo(rgb.AsSpan(Math.Max(0, Bytes)));
            return new(reference.Width, reference.Height, rgb);
        }
        var pixels = new PixelMapping(this, mine, reference);
        return Picture.Create(reference.Width, reference.Height, (x, y) => pixels.At(x, y) ?? reference[x, y]);
    }
}

/// <summary>The pixels of a picture after a change that moves no bytes.</summary>
internal readonly struct PixelMapping(PictureTransform transform, Picture mine, Picture reference)
{
    private readonly TurnedIndices indices = TurnedIndices.Create(transform.Turn, mine.Width, mine.Height);
    private readonly (int R, int G, int B) order =
        (transform.Channels.IndexOf('R'), transform.Channels.IndexOf('G'), transform.Channels.IndexOf('B'));
    private readonly byte[] rgb = mine.Rgb;
    private readonly (int Right, int Down, int Width, int Height) area = (transform.Right, transform.Down, reference.Width, reference.Height);

    /// <summary>A pixel as it becomes; null where nothing moves to.</summary>
    public (byte R, byte G, byte B)? At(int x, int y)
    {
        var (fromX, fromY) = (x - area.Right, y - area.Down);
        if ((uint)fromX >= (uint)area.Width || (uint)fromY >= (uint)area.Height) return null;
        var from = rgb.AsSpan((indices.Start + fromX * indices.Right + fromY * indices.Down) * 3, 3);
        return (from[order.R], from[order.G], from[order.B]);
    }
}
