using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Members of a crowd that are looked at together: which of a part's packets each of them is asked about.</summary>
[InlineArray(Count)]
internal struct CrowdBatch
{
    /// <summary>The most members. What one of them hides of the others is noticed only afterwards; with 4 to 16 the loss and the gain are about even.</summary>
    public const int Count = 4;

    private (CrowdGroup Group, int Place, (int First, int End) Packets, bool IsClear) first;
}
