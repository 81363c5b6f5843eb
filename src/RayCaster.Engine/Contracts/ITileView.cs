namespace RayCaster.Engine;

/// <summary>A view that can paint a tile by itself, where nothing but its model may show.</summary>
internal interface ITileView
{
    /// <summary>Writes the bytes of the tile that was entered last, mostly without computing where exactly the rays hit the model; returns false if
    /// it cannot.</summary>
    /// <param name="index">The model's place in it.</param>
    /// <param name="first">The place of the lowest row's first pixel.</param>
    /// <param name="step">From a pixel's place to that of the one above it.</param>
    bool Paint(Scene scene, int index, byte[] rgb, int first, int step);
}
