namespace RayCaster.Engine;

/// <summary>A part of the picture in which all rays surely hit some shapes, and nothing else can be nearer. Reused from part to part.</summary>
internal sealed class CoveredPart
{
    /// <summary>The part.</summary>
    public Tile Part { get; private set; }

    /// <summary>The shapes.</summary>
    public List<CoveringShape> Shapes { get; } = [];

    /// <summary>Goes to a part, whose shapes are to be added then.</summary>
    public void Enter(in Tile part)
    {
        Part = part;
        Shapes.Clear();
    }
}

/// <summary>A shape that all rays of a part hit.</summary>
/// <param name="View">Its view.</param>
/// <param name="Index">Its model's place in the scene.</param>
/// <param name="IsNear">Whether each hit is surely the shape's first crossing.</param>
internal readonly record struct CoveringShape(ICoveringView View, int Index, bool IsNear);
