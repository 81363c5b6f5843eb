namespace RayCaster.Engine;

/// <summary>A view that can paint a tile in which only its model may show.</summary>
internal interface ITileView
{
    /// <summary>Writes the bytes of the tile that was entered last, mostly without exact hits; returns false if it cannot.</summary>
    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    bool Paint(Scene scene, int index, byte[] rgb, int first, int step);
}
