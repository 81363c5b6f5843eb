using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Members of a crowd that are looked at together: which of a part's packets each of them is asked about.</summary>
[InlineArray(Count)]
internal struct CrowdBatch
{
    /// <summary>
    /// The most members. What one of them hides of the others is noticed only after the batch: 1 asks about 0.38 million packets in a picture of 100,000 spheres, 4 about 0.43
    /// and 8 about 0.51; but with 1 each waits for what the one before has hit.
    /// </summary>
    public const int Count = 4;

    private (CrowdGroup Group, int Place, (int First, int End) Packets, bool IsClear) first;
}
