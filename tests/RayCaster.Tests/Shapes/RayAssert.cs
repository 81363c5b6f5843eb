using System.Diagnostics;

namespace RayCaster.Tests.Shapes;

/// <summary>Casts one ray at one shape. A failure shows both in the slides' letters, and where the formula is.</summary>
[StackTraceHidden] // the trace of a failure begins in the test
internal static class RayAssert
{
    /// <summary>The hit of a ray that counts everything in front of its origin: t, or null for none.</summary>
    public static void Hits<P>(P shape, Vector3 origin, Vector3 direction, double? t, double tolerance = 0) where P : struct, IPrimitive =>
        HitsAlong(shape, new Ray(origin, direction.Normalized), t, tolerance);

    /// <inheritdoc cref="Hits{P}(P, Vector3, Vector3, double?, double)"/>
    public static void HitsAlong<P>(P shape, Ray ray, double? t, double tolerance = 0) where P : struct, IPrimitive =>
        Check(shape, ray, (t ?? double.NaN, double.NaN), (Model.Of(shape).Intersect(ray) ?? double.NaN, double.NaN), tolerance, "no hit");

    /// <summary>Both crossings with the line through the origin; NaN where there is none.</summary>
    public static void Crosses(IPrimitive shape, Vector3 origin, Vector3 direction, double near, double far, double tolerance = 0)
    {
        var ray = new Ray(origin, direction.Normalized);
        var got = shape.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction));
        Check(shape, ray, (near, far), (got.Near, got.Far), tolerance, "no crossing");
    }

    /// <summary>Lines for the end of a message: the ray and the shape, the slide, and the formula's file.</summary>
    public static string Describe(IPrimitive shape, Vector3 origin, Vector3 direction)
    {
        var (letters, slide) = shape switch
        {
            Plane p => ($"Plane    Q = {p.Point}, n = {p.Normal}", "Ray – Plane Intersection"),
            Sphere s => (FormattableString.Invariant($"Sphere   C = {s.Center}, R = {s.Radius}"), "Sphere – Geometric Solution"),
            Aabb b => ($"Aabb     B0 = {b.Min}, B1 = {b.Max}", "AABB checking for intersection"),
            Circle c => (FormattableString.Invariant($"Circle   C = {c.Center}, n = {c.Normal}, R = {c.Radius}"), "Circle"),
            Triangle t => ($"Triangle A = {t.A}, B = {t.B}, C = {t.C}", "Triangle"),
            _ => throw new ArgumentException($"no slide has a {shape.GetType().Name}", nameof(shape)),
        };
        return $"""

              Ray      P = {origin}, d = {direction}
              {letters}
              Slide "{slide}": src/RayCaster/Shapes/{shape.GetType().Name}.cs
            """;
    }

    private static void Check(
        IPrimitive shape, Ray ray, (double, double) expected, (double, double) got, double tolerance, string none)
    {
        if (AreEqual(expected.Item1, got.Item1, tolerance) && AreEqual(expected.Item2, got.Item2, tolerance)) return;
        Assert.Fail($"expected {Text(expected, none)}, but got {Text(got, none)}.{Describe(shape, ray.Origin, ray.Direction)}");
    }

    private static bool AreEqual(double a, double b, double tolerance) => a.Equals(b) || Math.Abs(a - b) <= tolerance;

    private static string Text((double Near, double Far) t, string none) =>
        !double.IsNaN(t.Far) ? FormattableString.Invariant($"t = {t.Near} and {t.Far}")
        : !double.IsNaN(t.Near) ? FormattableString.Invariant($"t = {t.Near}")
        : none;
}
