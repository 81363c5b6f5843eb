namespace RayCaster;

/// <summary>The ray parameters at which a ray crosses a primitive, nearest first; NaN where there is none.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
public readonly struct Crossings<N>(N near, N far) where N : struct, IReal<N>
{
    /// <summary>The first crossing along the ray.</summary>
    public readonly N Near = near;

    /// <summary>The second crossing, where the ray leaves a solid; NaN for a surface that is crossed once.</summary>
    public readonly N Far = far;

    /// <summary>The one crossing of a surface.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings(N only) : this(only, double.NaN) { }
}
