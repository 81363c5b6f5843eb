namespace RayCaster.Teaching.Comparison;

/// <summary>Colours between a few of a scale, each lighter than the one before, so that the order is visible in print and to colour-blind
/// people.</summary>
/// <param name="scale">From dark to bright, as 0xRRGGBB.</param>
internal sealed class ColorRamp(params uint[] scale)
{
    /// <summary>Nine colours of matplotlib's inferno (S. van der Walt and N. Smith 2015, public domain): black, purple, red, orange, pale
    /// yellow.</summary>
    public static readonly ColorRamp Inferno = new(0x000004, 0x1F0C48, 0x550F6D, 0x88226A, 0xBA3655, 0xE35933, 0xF98C0A, 0xF9C932, 0xFCFFA4);

    /// <summary>Nine colours of its viridis, whose lightness grows evenly: equal steps of a number look equal.</summary>
    public static readonly ColorRamp Viridis = new(0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725);

    /// <summary>The greatest position.</summary>
    public int Last => scale.Length - 1;

    /// <summary>The colour at a position from 0 to <see cref="Last"/>.</summary>
    public (byte R, byte G, byte B) At(double position)
    {
        var below = Math.Min((int)position, Last - 1);
        var rest = position - below;
        return (Mix(16), Mix(8), Mix(0));

        byte Mix(int shift) => (byte)((scale[below] >> shift & 255) * (1 - rest) + (scale[below + 1] >> shift & 255) * rest + 0.5);
    }
}
