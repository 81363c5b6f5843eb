namespace RayCaster.Cli;

/// <summary>
/// A picture in a terminal's characters, built while its lines are drawn. A character has two cells: the block "▀" shows the upper one in its
/// own colour and the lower one in the background's. A cell has the mean of its pixels' bytes.
/// </summary>
internal sealed class TerminalPreview
{
    /// <summary>Characters for terminals without colours, from dark to bright.</summary>
    private const string Ramp = " .:-=+*#%@";

    private readonly int across, down;
    private readonly SmallPicture cells;

    public TerminalPreview(int width, int height, int columns, int lines)
    {
        var scale = Math.Min(1, Math.Min((double)columns / width, 2.0 * lines / height)); // a small picture is not enlarged
        (across, down) = (Math.Max(1, (int)Math.Round(width * scale)), Math.Max(1, (int)Math.Round(height * scale)));
        cells = new(width, height, across, down);
    }

    public void Take(ReadOnlySpan<byte> rgb) => cells.Take(rgb);

    public string Text(ColorDepth depth)
    {
        var text = new StringBuilder();
        for (var y = 0; y < down; y += 2) text.Append(depth == ColorDepth.None ? Plain(y) : Colored(y, depth)).Append('\n');
        return text.ToString();
    }

    private string Plain(int y)
    {
        return string.Concat(Enumerable.Range(0, across).Select(Character)).TrimEnd();

        char Character(int x)
        {
            var light = y + 1 < down ? (Light(cells.Picture[x, y]) + Light(cells.Picture[x, y + 1])) / 2 : Light(cells.Picture[x, y]);
            return Ramp[Math.Min((int)(light / 256 * Ramp.Length), Ramp.Length - 1)];
        }
    }

    private string Colored(int y, ColorDepth depth)
    {
        var text = new StringBuilder();
        for (var x = 0; x < across; x++)
        {
            AddColor(38, x, y);
            if (y + 1 < down) AddColor(48, x, y + 1);
            text.Append('\u2580');
        }
        return text.Append("\e[0m").ToString();

        void AddColor(int ground, int x, int y)
        {
            var color = cells.Picture[x, y];
            if (x > 0 && color == cells.Picture[x - 1, y]) return;
            text.Append($"\e[{ground};{(depth == ColorDepth.Palette ? $"5;{PlaceInPalette(color)}" : $"2;{color.R};{color.G};{color.B}")}m");
        }
    }

    /// <summary>The nearest of xterm's 256 colours: a cube of 6 × 6 × 6 from 16 on, and 24 greys from 232 on. Users can change the first 16, so
    /// these are not used.</summary>
    private static int PlaceInPalette((byte R, byte G, byte B) color)
    {
        var (r, g, b) = (Step(color.R), Step(color.G), Step(color.B));
        var grey = Math.Clamp(((color.R + color.G + color.B) / 3 - 3) / 10, 0, 23);
        var level = 8 + 10 * grey;
        return Distance(level, level, level) < Distance(Level(r), Level(g), Level(b)) ? 232 + grey : 16 + 36 * r + 6 * g + b;

        static int Step(int value) => value < 48 ? 0 : value < 115 ? 1 : (value - 35) / 40; // halfway between the levels 0, 95, 135, 175, 215, 255
        static int Level(int step) => step == 0 ? 0 : 55 + 40 * step;
        int Distance(int x, int y, int z) => Square(color.R - x) + Square(color.G - y) + Square(color.B - z);
        static int Square(int x) => x * x;
    }

    /// <summary>How bright a colour looks, 0 to 255 (the weights of Rec. 709).</summary>
    private static double Light((byte R, byte G, byte B) color) => 0.2126 * color.R + 0.7152 * color.G + 0.0722 * color.B;
}
