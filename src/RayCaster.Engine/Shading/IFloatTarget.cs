using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Takes the pixels of a part that one of its shapes would show.</summary>
internal interface IFloatTarget
{
    /// <summary>Takes sixteen pixels side by side.</summary>
    /// <param name="row">Their row in the part.</param>
    /// <param name="packet">The number of their packet in the row.</param>
    /// <param name="t">Where the shape is hit.</param>
    /// <param name="least">The least byte that each channel may have.</param>
    /// <param name="most">The greatest; the same, unless the pixel is in doubt.</param>
    void Take(int row, int packet, Vector512<float> t, Vector512<int> least, Vector512<int> most);
}
