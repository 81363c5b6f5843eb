namespace RayCaster.Teaching;

/// <summary>A change of the whole picture that makes it agree with the right one.</summary>
/// <param name="Turn">How the picture must be turned or mirrored.</param>
/// <param name="Right">By how many pixels it must be moved to the right after that.</param>
/// <param name="Down">By how many lines it must be moved down.</param>
/// <param name="Colors">The change of its colours that must be undone; null for none.</param>
/// <param name="Bytes">By how many bytes all its bytes must be moved towards the end of the file.</param>
/// <param name="SidesSwapped">Whether its bytes are in the right order, but width and height are swapped.</param>
internal sealed record Change(
    Turn Turn = Turn.None, int Right = 0, int Down = 0, ColorChange? Colors = null, int Bytes = 0, bool SidesSwapped = false)
{
    /// <summary>How complex the change is. Of changes with the same effect, the simplest is reported.</summary>
    internal int Complexity =>
        (Turn == Turn.None ? 0 : 100) + (Right == 0 && Down == 0 ? 0 : 100 + Math.Abs(Right) + Math.Abs(Down))
        + (Colors is null ? 0 : 100) + (Bytes == 0 ? 0 : 100 + Math.Abs(Bytes));

    /// <summary>The change in words that follow "when".</summary>
    public string Description =>
        SidesSwapped ? "its width and height are swapped and its bytes left as they are: the header names them the wrong way round"
        : Bytes < 0 ? $"all bytes are moved by {-Bytes} towards the beginning: the header is followed by bytes that do not belong there"
        : Bytes > 0 ? $"all bytes are moved by {Bytes} towards the end: bytes after the header are missing"
        : string.Join(" and ", ((string?[])[Turning, Moving, Colors?.Description]).OfType<string>());

    private string? Turning => Turn switch
    {
        Turn.None => null,
        Turn.TopBottom => "it is flipped top to bottom",
        Turn.LeftRight => "it is mirrored left to right",
        Turn.Half => "it is turned by 180°",
        Turn.Transposed => "it is transposed (columns for lines)",
        Turn.Clockwise => "it is turned by 90° clockwise",
        Turn.CounterClockwise => "it is turned by 90° counter-clockwise",
        _ => "it is transposed (columns for lines) and turned by 180°",
    };

    private string? Moving
    {
        get
        {
            var right = $"{Digits.Count(Math.Abs(Right), "pixel")} to the {(Right > 0 ? "right" : "left")}";
            var down = $"{Digits.Count(Math.Abs(Down), "line")} {(Down > 0 ? "down" : "up")}";
            return (Right, Down) switch
            {
                (0, 0) => null,
                (_, 0) => $"it is moved {right}",
                (0, _) => $"it is moved {down}",
                _ => $"it is moved {right} and {down}",
            };
        }
    }

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
        var pixels = new MendedPixels(this, mine, reference);
        return Picture.Of(reference.Width, reference.Height, (x, y) => pixels.At(x, y) ?? reference[x, y]);
    }
}

/// <summary>The pixels of a picture in which a change is undone that moves no bytes.</summary>
internal readonly struct MendedPixels(Change change, Picture mine, Picture reference)
{
    private readonly TurnedPlaces places = TurnedPlaces.Of(change.Turn, mine.Width, mine.Height);
    private readonly ToneTable tones = change.Colors?.Tones ?? ToneTable.Same;
    private readonly (int R, int G, int B) order = change.Colors?.Places ?? (0, 1, 2);
    private readonly Picture mine = mine, reference = reference;
    private readonly int right = change.Right, down = change.Down;

    /// <summary>A pixel as it becomes; null where nothing moves to.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (byte R, byte G, byte B)? At(int x, int y)
    {
        var (fromX, fromY) = (x - right, y - down);
        if ((uint)fromX >= (uint)reference.Width || (uint)fromY >= (uint)reference.Height) return null;
        var from = mine.Rgb.AsSpan((places.Start + fromX * places.Right + fromY * places.Down) * 3, 3);
        var to = reference.Rgb.AsSpan((y * reference.Width + x) * 3, 3);
        return (tones.Undo(from[order.R], to[0]), tones.Undo(from[order.G], to[1]), tones.Undo(from[order.B], to[2]));
    }
}
