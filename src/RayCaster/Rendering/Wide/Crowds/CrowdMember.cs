namespace RayCaster;

/// <summary>What is known of a model of a crowd before its formula is asked.</summary>
internal struct CrowdMember
{
    /// <summary>The pixels where it may show: columns from Left and rows from Bottom, the ends not included.</summary>
    public int Left, Bottom, Right, Top;

    /// <summary>None of its hits is nearer.</summary>
    public float Nearest;

    /// <summary>Its group, and its place there.</summary>
    public int Group, Place;
}
