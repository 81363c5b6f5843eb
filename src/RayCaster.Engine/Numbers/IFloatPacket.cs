namespace RayCaster.Engine;

/// <summary>
/// Floats of pixels side by side, and of as many above them; as a mask all bits of a lane set for true, none for false. A formula over it is much
/// faster than over doubles, and <see cref="ErrorBound"/> bounds its error. Two rows share the broadcasts of a formula's constants, a sixth of the
/// work.
/// </summary>
internal interface IFloatPacket<F> : IReal<F> where F : struct, IFloatPacket<F>
{
    /// <summary>How many pixels of a row it holds.</summary>
    static abstract int Count { get; }

    /// <summary>A number for each pixel of a row, the same in both rows.</summary>
    static abstract F Row(float[] numbers, int first);

    /// <summary>A number for each of the two rows.</summary>
    static abstract F PerRow(float[] numbers, int first);

    /// <summary>A number for each pixel of two rows.</summary>
    static abstract F Rows(float[] lower, float[] upper, int first);

    /// <summary>The whole parts of three channels' levels: three bytes for each pixel, in place of its float.</summary>
    static abstract F Pixels(F r, F g, F b);

    /// <summary>Writes the bytes of some pixels of <see cref="Pixels"/>, whose lower row has the greatest levels of each pixel, and whose upper row
    /// the least; and says which pixels are uncertain.</summary>
    /// <param name="ends">The lower row is 0 for pixels without a hit.</param>
    /// <returns>A bit for each uncertain pixel.</returns>
    uint WriteRange(F ends, int background, byte[] rgb, int place, int count);

    /// <summary>Writes the bytes of hits, and says which are uncertain. The lower row is written last: if there is no upper row, both may have the
    /// same place.</summary>
    /// <returns>A bit for each pixel with an uncertain byte, the lower row's lowest.</returns>
    uint Write(in FloatLevels levels, byte[] rgb, int lower, int upper);
}
