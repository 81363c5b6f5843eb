namespace RayCaster.Engine;

/// <summary>
/// Floats of pixels side by side; as a mask all bits of a lane set for true, none for false. A formula over it is much faster than over doubles, and
/// <see cref="ErrorBound"/> bounds its error.
/// </summary>
internal interface IFloatPacket<F> : IReal<F> where F : struct, IFloatPacket<F>
{
    /// <summary>How many pixels it holds.</summary>
    static abstract int Count { get; }

    static abstract F Load(float[] numbers, int first);

    /// <summary>Loads and rounds.</summary>
    static abstract F Load(double[] numbers, int first);

    /// <summary>Indices + 1 as ints, in offset of floats.</summary>
    static abstract F LoadColorIndices(double[] indices, int first);

    /// <summary>The colours at some colorIndices, in steps.</summary>
    /// <param name="colors"><see cref="FloatColors.Packed"/>.</param>
    static abstract (F R, F G, F B) ColorsAt(RawSpan<long> colors, F colorIndices);

    /// <summary>The whole parts of three channels' levels: three bytes for each pixel, in offset of its float.</summary>
    static abstract F Pixels(F r, F g, F b);

    /// <summary>Writes the bytes of some pixels of <see cref="Pixels"/> with the least levels, and says which differ from those with the
    /// greatest.</summary>
    /// <param name="candidateDepth">0 for pixels without a hit, as a float or as an int.</param>
    /// <returns>A bit for each uncertain pixel.</returns>
    static abstract uint WriteRange(F least, F most, F candidateDepth, int background, byte[] rgb, int offset);

    /// <summary>Writes the bytes of hits.</summary>
    /// <returns>A bit for each pixel with an uncertain byte.</returns>
    uint Write(in FloatLevels levels, byte[] rgb, int offset);
}
