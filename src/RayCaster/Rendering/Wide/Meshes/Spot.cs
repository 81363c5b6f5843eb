namespace RayCaster;

/// <summary>A triangle so small that it may cover one sample only.</summary>
/// <param name="Pixel">The sample's pixel, by the pixels of <see cref="TileFilter"/>, in the tile of full size that it lies in.</param>
/// <param name="Triangle">The mesh's triangle.</param>
/// <param name="LeastW">If the sample is surely covered, w is not less than this; otherwise −1.</param>
/// <param name="MostW">w is not more than this.</param>
internal readonly record struct Spot(int Pixel, int Triangle, float LeastW, float MostW);
