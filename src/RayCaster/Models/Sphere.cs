using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A sphere, visible from outside and from inside.</summary>
/// <param name="Center">C.</param>
/// <param name="Radius">R &gt; 0.</param>
public readonly record struct Sphere(Vector3 Center, double Radius) : IPrimitive, IBounded, IRound, ISurface
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

    /// <summary>X − C, normalised.</summary>
    Vector3 ISurface.Normal(Vector3 X) => (X - Center).Normalized;

    /// <summary>Longitude and latitude: u runs from 0 to 1 once around the z axis, from −x over −y, x and y; v from 0 at the lower pole to 1 at
    /// the upper.</summary>
    (double U, double V) ISurface.Parameters(Vector3 X)
    {
        var n = (X - Center).Normalized;
        return (0.5 + Math.Atan2(n.Y, n.X) / (2 * Math.PI), 0.5 + Math.Asin(Math.Clamp(n.Z, -1, 1)) / Math.PI);
    }
}
