using System.Globalization;

namespace RayCaster.Testing;

/// <summary>
/// Compares a picture with a reference: equal within 1 of 255, and off by 1 in at most 1 % of the pixels, so that truncating instead
/// of rounding shows. On an outline a pixel may show either neighbour, and nothing else.
/// </summary>
internal sealed class ReferenceComparison
{
    private readonly Reference reference;
    private readonly Picture expected, actual;
    private readonly int largest;
    private readonly (int X, int Y)? first;

    public ReferenceComparison(Reference reference, Picture actual)
    {
        (this.reference, expected, this.actual) = (reference, reference.Picture, actual);
        if (!SameSize) return;
        for (var y = 0; y < expected.Height; y++)
            for (var x = 0; x < expected.Width; x++)
            {
                if (expected[x, y] == actual[x, y]) continue;
                var difference = Difference(x, y);
                if (difference == 0) continue;
                largest = Math.Max(largest, difference);
                if (difference == 1) OffByOne++;
                else
                {
                    Wrong++;
                    first ??= (x, y);
                }
            }
    }

    /// <summary>Pixels that differ by more than 1.</summary>
    public int Wrong { get; }

    /// <summary>Pixels that differ by 1.</summary>
    public int OffByOne { get; }

    /// <summary>Whether the pictures are equal by this rule.</summary>
    public bool IsEqual => SameSize && Wrong == 0 && OffByOne <= Pixels / 100;

    private int Pixels => expected.Width * expected.Height;

    private string Percent(int pixels) => (100.0 * pixels / Pixels).ToString("0.##", CultureInfo.InvariantCulture);

    private bool SameSize => (expected.Width, expected.Height) == (actual.Width, actual.Height);

    /// <summary>What is wrong, and the command that explains the first wrong pixel.</summary>
    /// <param name="name">The reference's name, without <c>.png</c>: that of its scene.</param>
    public string Describe(string name)
    {
        if (!SameSize) return $"{name}.png: expected {expected.Width} × {expected.Height} pixels, got {actual.Width} × {actual.Height}";
        if (first is not var (x, y))
            return $"{name}.png: {OffByOne} of {Pixels} pixels ({Percent(OffByOne)} %) are off by 1; at most 1 % may be";
        return $"{name}.png: {Wrong} of {Pixels} pixels ({Percent(Wrong)} %) differ, by at most {largest}; "
            + $"the first at column {x}, line {y} from the top: expected {expected[x, y]}, got {actual[x, y]}\n"
            + $"  dotnet run --project src/RayCaster.Cli -- explain scenes/{name}.json {x} {y} --size {expected.Width}x{expected.Height}";
    }

    /// <summary>The reference, dark; red where the picture differs, yellow where it is off by 1; nothing if the sizes differ.</summary>
    public Picture? Draw()
    {
        if (!SameSize) return null;
        var picture = new Picture(expected.Width, expected.Height);
        for (var y = 0; y < expected.Height; y++)
            for (var x = 0; x < expected.Width; x++)
            {
                var (r, g, b) = expected[x, y];
                picture[x, y] = Difference(x, y) switch
                {
                    0 => ((byte)(r / 4), (byte)(g / 4), (byte)(b / 4)),
                    1 => (160, 160, 0),
                    _ => (255, 0, 0),
                };
            }
        return picture;
    }

    /// <summary>The largest difference of a channel; on an outline that from the nearest of the nine colours around the pixel.</summary>
    private int Difference(int x, int y)
    {
        var reach = reference.IsOutline(x, y) ? 1 : 0;
        var least = 255;
        for (var j = Math.Max(0, y - reach); j <= Math.Min(expected.Height - 1, y + reach); j++)
            for (var i = Math.Max(0, x - reach); i <= Math.Min(expected.Width - 1, x + reach); i++)
            {
                var ((r, g, b), got) = (expected[i, j], actual[x, y]);
                least = Math.Min(least, Math.Max(Math.Abs(r - got.R), Math.Max(Math.Abs(g - got.G), Math.Abs(b - got.B))));
            }
        return least;
    }
}
