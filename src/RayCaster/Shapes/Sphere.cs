using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A sphere, visible from outside and from inside.</summary>
/// <param name="Center">C.</param>
/// <param name="Radius">R &gt; 0.</param>
public readonly record struct Sphere(Vector3 Center, double Radius) : IPrimitive, IBounded
{
    /// <inheritdoc/>
    public Bounds Bounds => new(Center - new Vector3(Radius, Radius, Radius), Center + new Vector3(Radius, Radius, Radius));

    /// <summary>
    /// Slide "Sphere – Geometric Solution": t = tca ∓ thc. tca is the parameter of the ray's point nearest to C, thc half of the chord.
    /// </summary>
    /// <remarks>
    /// The slide computes the distance of C from the ray by Pythagoras: D² = L² − tca². For a far sphere both terms are large and nearly
    /// equal, and their difference loses digits, which moves the outline. The vector from the ray to C has the same length and keeps these
    /// digits (Haines, Günther, Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", 2019).
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var L = (Center - ray.Origin).As("L");
        var tca = (L * ray.Direction).As("tca");
        var D = (L - tca * ray.Direction).As("D");      // from the ray's nearest point to C
        var thc = N.Sqrt(Radius * Radius - D * D).As("thc");       // NaN where the ray passes by
        return new(tca - thc, tca + thc);
    }

    /// <summary>
    /// Slide "Sphere – Analytical Solution": the roots of a t² + b t + c = 0. The same crossings, but b² and 4 a c lose digits for far spheres,
    /// so no picture is drawn by it.
    /// </summary>
    public Crossings<N> IntersectAnalytically<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var CP = ray.Origin - Center;
        var a = ray.Direction * ray.Direction; // 1 but for rounding
        var b = 2 * (CP * ray.Direction);
        var c = CP * CP - Radius * Radius;
        var root = N.Sqrt(b * b - 4 * a * c); // NaN where the ray passes by
        return new((-b - root) / (2 * a), (-b + root) / (2 * a));
    }
}
