namespace RayCaster.Engine;

/// <summary>What is known of a member of a batch before its formula is computed.</summary>
internal struct BatchItem
{
    /// <summary>The pixels where it may show.</summary>
    public PixelRect ShowsIn;

    /// <summary>No hit of it is nearer.</summary>
    public float Nearest;

    public int Kind, Index;

    /// <summary>Whether all of its hits certainly count.</summary>
    public bool IsClear;
}
