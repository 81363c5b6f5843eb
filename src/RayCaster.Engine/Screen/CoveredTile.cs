namespace RayCaster.Engine;

/// <summary>A part of the picture in which all rays certainly hit one shape, and nothing else can be nearer.</summary>
/// <param name="IsFirstCrossing">Whether each hit is certainly the shape's first crossing.</param>
internal readonly record struct CoveredTile(PixelRect Part, ModelView View, int Index, bool IsFirstCrossing);
