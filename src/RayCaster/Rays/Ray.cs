namespace RayCaster;

/// <summary>A ray X(t) = P + t d (slide "Ray").</summary>
public sealed class Ray(Vector3 origin, Vector3 direction)
{
    /// <summary>P, where the ray starts.</summary>
    public Vector3 Origin { get; } = origin;

    /// <summary>d, of length 1.</summary>
    public Vector3 Direction { get; } = direction;

    /// <summary>Which crossings count. For a ray without a camera: all that are not behind its origin.</summary>
    public ClipRange ClipRange { get; init; } = ClipRange.Everything;

    /// <summary>The depth z in front of the camera per unit of t: the cosine between the ray and the view. zNear and zFar limit z = t · this, and it
    /// is 1 if they limit the distance.</summary>
    public double DepthPerT { get; init; } = 1;

    /// <summary>The point X(t) = P + t d. The formulas that draw use <see cref="Ray{N}.At"/>.</summary>
    public Vector3 At(double t) => Origin + t * Direction;

    /// <summary>Whether a crossing at t counts: not behind, beyond the bias, within the clip range. False for NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Counts(double t) => ClipRange.CountsMask<Scalar>(t, DepthPerT).Holds;

    /// <summary>Whether a hit replaces the nearest one before it; false where t is NaN.</summary>
    /// <param name="nearest">The parameter of the nearest hit before it; +∞ before the first.</param>
    public static N IsNearer<N>(N t, N nearest) where N : struct, IReal<N> => t < nearest;
}
