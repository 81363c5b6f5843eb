namespace RayCaster.Teaching;

/// <summary>A change of a picture's colours, the same in every pixel: its channels stand in another order, or each goes through a formula.</summary>
/// <param name="Description">What undoes it, in words that follow "when"; c is a channel of the right picture, 0 to 1.</param>
/// <param name="Order">The letters of RGB in the order in which the changed colour has them.</param>
/// <param name="Tones">The bytes from which a changed byte may come.</param>
/// <param name="Exponent">The power to which c is raised; null for another formula.</param>
/// <param name="Factor">What c is multiplied by; null for another formula.</param>
/// <param name="Offset">What is added to c · Factor, 1 being full intensity; null for another formula.</param>
internal sealed record ColorChange(
    string Description, string Order, ToneTable Tones, double? Exponent = null, double? Factor = null, double? Offset = null)
{
    /// <summary>All orders of the channels but the right one.</summary>
    public static ColorChange[] Orders { get; } = [Ordered("BGR"), Ordered("GRB"), Ordered("RBG"), Ordered("GBR"), Ordered("BRG")];

    public static ColorChange Inverted { get; } = new("it is inverted: it shows 1 − c instead of c, a negative", "RGB", new(c => 1 - c));

    public static ColorChange Srgb { get; } = new("the gamma of sRGB is removed: the bytes must be linear", "RGB", new(SrgbOf));

    /// <summary>Whether the order of the channels changes, and not a formula.</summary>
    public bool IsOrder => Tones == ToneTable.Same;

    /// <summary>The places, from 0, at which the changed colour has the original's channels.</summary>
    public (int R, int G, int B) Places { get; } = (Order.IndexOf('R'), Order.IndexOf('G'), Order.IndexOf('B'));

    public static ColorChange Ordered(string order) => new(order switch
    {
        "BGR" => "red and blue are swapped",
        "GRB" => "red and green are swapped",
        "RBG" => "green and blue are swapped",
        _ => $"its channels are reordered: the bytes of a pixel stand in the order {order[0]}, {order[1]}, {order[2]}",
    }, order, ToneTable.Same);

    public static ColorChange Power(double exponent) => new(
        FormattableString.Invariant($"gamma is undone: it shows c^{exponent:0.###} instead of c{Gamma(exponent)}"),
        "RGB", new(c => Math.Pow(c, exponent)), Exponent: exponent);

    /// <summary>c · factor + offset, clamped.</summary>
    public static ColorChange Linear(double factor, double offset) => new(
        FormattableString.Invariant($"its brightness is corrected: it shows {Times(factor)}{Plus(offset)} instead of c"),
        "RGB", new(c => factor * c + offset), Factor: factor, Offset: offset);

    /// <summary>What sRGB (IEC 61966-2-1) stores for a linear channel.</summary>
    public static double SrgbOf(double c) => c <= 0.0031308 ? 12.92 * c : 1.055 * Math.Pow(c, 1 / 2.4) - 0.055;

    private static string Gamma(double exponent) =>
        exponent < 1 ? FormattableString.Invariant($" (gamma {1 / exponent:0.##}; the bytes must be linear)") : "";

    private static string Times(double factor) => factor == 1 ? "c" : FormattableString.Invariant($"{factor:0.####} c");

    private static string Plus(double offset) =>
        offset == 0 ? "" : FormattableString.Invariant($" {(offset < 0 ? '−' : '+')} {Math.Abs(offset) * 255:0.#}/255");
}

/// <summary>For each changed byte the least and the greatest byte that it may come from.</summary>
internal sealed class ToneTable
{
    private readonly byte[] least = new byte[256], greatest = new byte[256];

    /// <param name="formula">The change of a channel, 0 to 1, before rounding; it is monotonic.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public ToneTable(Func<double, double> formula)
    {
        // A byte stands for channels half a level to either side of it, and is rounded or truncated after the change.
        var (low, high) = (new int[256], new int[256]);
        for (var before = 0; before < 256; before++)
        {
            var (a, b) = (Level(formula, before - 0.5), Level(formula, before + 0.5));
            low[before] = (int)Math.Floor(Math.Min(a, b));
            high[before] = (int)Math.Floor(Math.Max(a, b) + 0.5);
        }
        var away = new int[256]; // by how many levels a byte fails to become the changed one
        for (var after = 0; after < 256; after++)
        {
            for (var before = 0; before < 256; before++) away[before] = Math.Max(0, Math.Max(low[before] - after, after - high[before]));
            var nearest = away.Min();
            least[after] = (byte)Array.IndexOf(away, nearest);
            greatest[after] = nearest == 0 ? (byte)Array.LastIndexOf(away, 0) : least[after];
        }
    }

    private ToneTable()
    {
        for (var i = 0; i < 256; i++) least[i] = greatest[i] = (byte)i;
    }

    public static ToneTable Same { get; } = new();

    /// <summary>The byte before the change: of the possible ones, the one nearest to the expected byte.</summary>
    public byte Undo(byte after, byte expected) => Math.Clamp(expected, least[after], greatest[after]);

    private static double Level(Func<double, double> formula, double before) =>
        Math.Clamp(formula(Math.Clamp(before / 255, 0, 1)), 0, 1) * 255;
}
