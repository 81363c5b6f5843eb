namespace RayCaster.Engine;

/// <summary>What is known of a member of a batch before its formula is computed.</summary>
internal readonly struct BatchItem(PixelRect showsIn, float nearest, int kind, int index, bool allHitsCount)
{
    /// <summary>The pixels where it may show.</summary>
    public readonly PixelRect ShowsIn = showsIn;

    /// <summary>No hit of it is nearer.</summary>
    public readonly float Nearest = nearest;

    public readonly int Kind = kind, Index = index;

    /// <summary>Whether all of its hits certainly count.</summary>
    public readonly bool AllHitsCount = allHitsCount;
}
