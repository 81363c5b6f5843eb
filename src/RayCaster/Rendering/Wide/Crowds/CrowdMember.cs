using System.Runtime.InteropServices;

namespace RayCaster;

/// <summary>What is known of a model of a crowd before its formula is asked; two of them fill a line of the cache.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct CrowdMember
{
    /// <summary>The pixels where it may show: columns from Left and rows from Bottom, the ends not included.</summary>
    public int Left, Bottom, Right, Top;

    /// <summary>None of its hits is nearer.</summary>
    public float Nearest;

    /// <summary>No hit of this and of all members that come later is nearer.</summary>
    public float NearestOfRest;

    /// <summary>Its group, and its place there.</summary>
    public int Group, Place;
}
