namespace RayCaster;

/// <summary>The rays X(t) = P + t d that a formula computes with: one ray, a packet of rays, or all rays of a region.</summary>
public readonly struct Ray<N>(Vector3<N> origin, Vector3<N> direction) where N : struct, IReal<N>
{
    /// <summary>P, where the ray starts.</summary>
    public readonly Vector3<N> Origin = origin;

    /// <summary>d, of length 1.</summary>
    public readonly Vector3<N> Direction = direction;

    /// <summary>The point X(t) = P + t d (slide "Ray").</summary>
    public Vector3<N> At(N t) => Origin + t * Direction;
}
