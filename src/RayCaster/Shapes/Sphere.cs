namespace RayCaster;

/// <summary>A sphere, visible from outside and from inside.</summary>
/// <param name="Center">C.</param>
/// <param name="Radius">R &gt; 0.</param>
public readonly record struct Sphere(Vector3 Center, double Radius) : IPrimitive, IBoundingSphere
{
    /// <summary>
    /// Slide "Sphere – Geometric Solution": t = t_ca ∓ t_hc. t_ca is the parameter of the ray's point nearest to C, t_hc half of the chord.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var L = (Center - ray.Origin).As("L");
        var t_ca = (L * ray.Direction).As("t_ca");
        // The slide's "t_ca should be greater than zero" is right only for a camera outside the sphere: from inside, one sees the sphere even if
        // its centre lies behind.

        // The slide's Pythagoras, D² = L² − t_ca², subtracts two large, nearly equal numbers for a far sphere, so it loses digits, and
        // the sphere's edge moves. D here is the vector from the ray's nearest point to C, whose length is the slide's D, without that loss
        // (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", 2019).
        var D = (L - t_ca * ray.Direction).As("D");
        var t_hc = N.Sqrt(Radius * Radius - D * D).As("t_hc"); // NaN where the ray passes by; the slide's t_hc² on the left is an error of the slide
        return new(t_ca - t_hc, t_ca + t_hc);
    }
}
