using static RayCaster.Teaching.SlideFormulas;
using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>In the formula of the sphere.</summary>
internal static class SphereMistakes
{
    public static Mistake[] All =>
    [
        new("r-nosq", Affects.Spheres, Slides.Sphere, "sphere: R where R² is meant",
            SphereRadius(R => Math.Sqrt(R)),
            "Spheres have a wrong size, or a wrong depth; one of radius 1 is right.",
            "Are both sides of your equation squares?",
            "t_hc = √(R² − D²)."),
        new Mistake("disc-nan", Affects.Spheres, Slides.Sphere, "sphere: the root of a negative number is taken, and NaN passes for a hit",
            NaNIsAHit((t, best) => !(t >= best)), // the same for numbers
            "Nearly all is black where a sphere is in the scene; only what is listed after it survives.",
            "What does Math.Sqrt give for −1, and what does NaN < 0 say?",
            "Return no hit where R² − D² < 0, before the root.")
            .Or("sphere: NaN passes for the first hit, and no t is less than that",
                NaNIsAHit((t, best) => double.IsPositiveInfinity(best) || t < best)),
        new("far-root", Affects.Spheres, Slides.Sphere, "sphere: the far root t = t_ca + t_hc is taken",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Far)),
            "Spheres look hollow: you see the inside of their far half.",
            "Which of t_ca − t_hc and t_ca + t_hc comes first?",
            "t = t_ca − t_hc, and t_ca + t_hc only if that does not count."),
        new Mistake("near-root-only", Affects.Spheres, Slides.Sphere, "sphere: the near root t = t_ca − t_hc or none",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Near)),
            "A sphere that the camera is in, or that is cut open, is not there.",
            "From inside, what is the sign of t_ca − t_hc?",
            "Where t_ca − t_hc does not count, try t_ca + t_hc.")
            .Or("sphere: no hit where t_ca − t_hc < 0", lab => lab.Sphere.Becomes(cross => (s, d) => UnlessBehind(cross(s, d)))),
        new("oc-sign", Affects.Spheres, Slides.Sphere, "sphere: P − C where C − P is meant, which mirrors the sphere at the camera",
            lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Center = 2 * lab.P - s.Center }, d)),
            "Spheres are missing; those behind the camera show.",
            "From where to where does L point?",
            "L = C − P, t_ca = L·d. (In the quadratic: b = 2 d·(P − C).)"),
        new("disc-2", Affects.Spheres, Slides.SphereAnalytical, "sphere: discriminant b² − a c, while b = 2 d·(P − C) has its 2",
            lab => lab.Sphere.Is((s, d) =>
            {
                var L = lab.P - s.Center;
                var a = d * d;
                var b = 2 * (d * L);
                var root = Math.Sqrt(b * b - a * (L * L - (double)s.Radius * s.Radius));
                return new((-b - root) / (2 * a), (-b + root) / (2 * a));
            }),
            "Spheres bleed over the picture, or have a wrong size or depth.",
            "Is the discriminant b² − 4ac or (b/2)² − ac? Which one fits your b?",
            "With b = 2 d·(P − C): b² − 4ac and t = (−b ∓ √…) / 2a."),
        new("tca-positive", Affects.Spheres, Slides.Sphere, "sphere: no hit where t_ca < 0, the slide's sentence taken literally",
            lab => lab.Sphere.Becomes(cross => (s, d) => (s.Center - lab.P) * d < 0 ? None : cross(s, d)),
            "From inside a sphere a part of it is missing: there the background shows.",
            "You are inside a sphere, its centre is behind you. What is the sign of t_ca, and is there a wall before you?",
            "t_ca < 0 says only that the centre lies behind; test t = t_ca + t_hc."),
        new("d-nosq", Affects.Spheres, Slides.Sphere, "sphere: t_hc = √(R² − D), with the distance D where D² is meant",
            Roots((R, t_ca, t_hc) => Both(t_ca, Math.Sqrt(R * R - Math.Sqrt(Math.Max(0, R * R - t_hc * t_hc))))),
            "Spheres have a wrong size, or are dented: too flat or too deep.",
            "D is a length. What is it taken from?",
            "t_hc = √(R² − D²), D² = L² − t_ca²."),
        new("thc-nosqrt", Affects.Spheres, Slides.Sphere, "sphere: t_hc = R² − D² without the root",
            Roots((_, t_ca, t_hc) => Both(t_ca, t_hc * t_hc)),
            "Spheres have the right outline, but bulge or are too flat: their light is wrong, and so is what covers them.",
            "In which unit is R² − D²: metres, or square metres?",
            "t_hc = √(R² − D²)."),
        new("tca-only", Affects.Spheres, Slides.Sphere, "sphere: t = t_ca, where the ray is nearest to the centre",
            Roots((_, t_ca, _) => new(t_ca)),
            "Spheres look like flat discs, and stand too deep in what they touch.",
            "What is at t = t_ca: the ray's way in, or its middle?",
            "t = t_ca − t_hc, and t_ca + t_hc if that does not count."),
        new Mistake("r-diameter", Affects.Spheres | Affects.Circles, Slides.Sphere, "sphere: the radius taken for a diameter, R / 2",
            SphereRadius(R => R / 2),
            "Round things are half as large as they should be, or twice.",
            "How far is it from the centre to the rim?",
            "R is the scene's radius as it is.")
            .Or("circle: R / 2", SurfaceMistakes.CircleRadius(R => R / 2)),
    ];

    /// <summary>Another radius of spheres, from the right one.</summary>
    private static Action<Lab> SphereRadius(Func<double, double> R) =>
        lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Radius = R((double)s.Radius) }, d));

    /// <summary>Other crossings of spheres, from R, t_ca and t_hc.</summary>
    private static Action<Lab> Roots(Func<double, double, double, Crossed> other) => lab => lab.Sphere.Becomes(cross => (s, d) =>
    {
        var crossed = cross(s, d);
        return other((double)s.Radius, (double)(crossed.Near + crossed.Far) / 2, (double)(crossed.Far - crossed.Near) / 2);
    });

    private static Crossed Both(double t_ca, double t_hc) => new(t_ca - t_hc, t_ca + t_hc);

    /// <summary>A ray that misses a sphere hits it at t = NaN.</summary>
    private static Action<Lab> NaNIsAHit(Func<double, double, bool> better) => lab =>
    {
        lab.Hit.Becomes(hit => (model, d) =>
            model is Model<Sphere> s && double.IsNaN(lab.Sphere.Do(s.Primitive, d).Near) ? double.NaN : hit(model, d));
        lab.Better.Is(better);
    };
}
