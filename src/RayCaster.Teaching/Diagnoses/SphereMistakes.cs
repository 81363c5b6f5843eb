using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>In the formula of the sphere.</summary>
internal static class SphereMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("r-nosq", Affects.Spheres, Slides.Sphere, "sphere: R where R² is meant",
            SphereRadius(R => Math.Sqrt(R)),
            "Spheres have a wrong size, or a wrong depth; one of radius 1 is right.",
            "Are both sides of your equation squares?",
            "thc = √(R² − D²).")
            .Or("sphere: 2 R where R² is meant", SphereRadius(R => Math.Sqrt(2 * R)))
            .Or("sphere: R⁴ where R² is meant", SphereRadius(R => R * R))
            .Or("sphere: D² > R asked where D² > R² is meant", lab => lab.PassesBy.Is((R, D2) => D2 > R))
            .Or("sphere: thc = √(R − D²), and D² > R² asked rightly", lab => lab.Thc2.Is((R, D2) => R - D2))
            .Or("sphere: thc = √|R − D²|", lab => lab.Thc2.Is((R, D2) => Math.Abs(R - D2)))
            .Or("sphere: thc = √(2 R − D²), D² > R² asked rightly", lab => lab.Thc2.Is((R, D2) => 2 * R - D2))
            .Or("sphere: D > R² asked where D > R is meant", lab => lab.PassesBy.Is((R, D2) => D2 > R * R * R * R)),
        new Mistake("disc-nan", Affects.Spheres, Slides.Sphere, "sphere: the root of a negative number is taken, and NaN passes for a hit",
            NoNumberHits((t, best) => !(t >= best)), // the same for numbers
            "Nearly all is black where a sphere is in the scene; only what is listed after it survives.",
            "What does Math.Sqrt give for −1, and what does NaN < 0 say?",
            "Return no hit where R² − D² < 0, before the root.")
            .Or("sphere: NaN passes for the first hit, and no t is less than that",
                NoNumberHits((t, best) => double.IsPositiveInfinity(best) || t < best))
            .Or("sphere: thc = √|R² − D²|, and every ray hits", Unasked((R, D2) => Math.Abs(R * R - D2))),
        new Mistake("far-root", Affects.Spheres, Slides.Sphere, "sphere: the far root t = tca + thc is taken",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Far)),
            "Spheres look hollow: you see the inside of their far half.",
            "Which of tca − thc and tca + thc comes first?",
            "t = tca − thc, and tca + thc only if that does not count.")
            .Or("sphere: the far root is tried first, then the near one", lab => lab.Sphere.Becomes(cross => (s, d) => Turned(cross(s, d)))),
        new Mistake("near-root-only", Affects.Spheres, Slides.Sphere, "sphere: the near root t = tca − thc or none",
            lab => lab.Sphere.Becomes(cross => (s, d) => new(cross(s, d).Near)),
            "A sphere that the camera is in, or that is cut open, is not there.",
            "From inside, what is the sign of tca − thc?",
            "Where tca − thc does not count, try tca + thc.")
            .Or("sphere: no hit where tca − thc < 0", lab => lab.Sphere.Becomes(cross => (s, d) => UnlessBehind(cross(s, d)))),
        new Mistake("oc-sign", Affects.Spheres, Slides.Sphere, "sphere: P − C where C − P is meant, which mirrors the sphere at the camera",
            lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Center = 2 * lab.P - s.Center }, d)),
            "Spheres are missing; those behind the camera show.",
            "From where to where does L point?",
            "L = C − P, tca = L·d. (In the quadratic: b = 2 d·(P − C).)")
            .In(OriginMistakes.FromNear)
            .Or("sphere: L = C + P", lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Center = s.Center + 2 * lab.P }, d)))
            .Or("sphere: L = −P, without C", lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Center = Vector3.Zero }, d)))
            .Or("sphere: thc − tca where tca − thc is meant", lab => lab.Roots.Is((tca, thc) => new(thc - tca, thc + tca))),
        new Mistake("disc-2", Affects.Spheres, Slides.SphereAnalytical, "sphere: discriminant b² − a c, while b = 2 d·(P − C) has its 2",
            lab => lab.Discriminant.Is((a, b, c) => b * b - a * c),
            "Spheres bleed over the picture, or have a wrong size or depth.",
            "Is the discriminant b² − 4ac or (b/2)² − ac? Which one fits your b?",
            "With b = 2 d·(P − C): b² − 4ac and t = (−b ∓ √…) / 2a.")
            .In(OriginMistakes.FromNear)
            .Or(OtherFactors())
            .Or("sphere: discriminant b − 4 a c", lab => lab.Discriminant.Is((a, b, c) => b - 4 * a * c))
            .Or("sphere: −b − √… / 2a without brackets", lab => lab.Solution.Is((a, b, D) => Around(-b, Math.Sqrt(D) / (2 * a))))
            .Or("sphere: c = (P − C)² + R²", lab => lab.R2.Is(R => -R * R)),
        new Mistake("tca-positive", Affects.Spheres, Slides.Sphere, "sphere: no hit where tca < 0, the slide's sentence taken literally",
            lab => lab.Sphere.Becomes(cross => (s, d) => (s.Center - lab.P) * d < 0 ? None : cross(s, d)),
            "From inside a sphere a part of it is missing: there the background shows.",
            "You are inside a sphere, its centre is behind you. What is the sign of tca, and is there a wall before you?",
            "tca < 0 says only that the centre lies behind; ask t = tca + thc.")
            .In(OriginMistakes.FromNear),
        new Mistake("d-nosq", Affects.Spheres, Slides.Sphere, "sphere: thc = √(R² − D), with the distance D where D² is meant",
            lab => lab.Thc2.Is((R, D2) => R * R - Math.Sqrt(D2)),
            "Spheres have a wrong size, or are dented: too flat or too deep.",
            "D is a length. What is it taken from?",
            "thc = √(R² − D²), D² = L² − tca².")
            .Or("sphere: thc = √|R² − D|", lab => lab.Thc2.Is((R, D2) => Math.Abs(R * R - Math.Sqrt(D2))))
            .Or("sphere: D > R² asked too", lab => lab.D2.Becomes(D2 => (L2, tca) => Math.Sqrt(D2(L2, tca))))
            .Or("sphere: thc = √(R² − D⁴)", Unasked((R, D2) => R * R - D2 * D2))
            .Or("sphere: D² = |L| − tca²", lab => lab.D2.Is((L2, tca) => Math.Sqrt(L2) - tca * tca))
            .Or("sphere: D² = L² − tca", lab => lab.D2.Is((L2, tca) => L2 - tca))
            .Or("sphere: D = |L| − tca", lab => lab.D2.Is((L2, tca) => (Math.Sqrt(L2) - tca) * (Math.Sqrt(L2) - tca)))
            .Or("sphere: D² = |L| − tca", lab => lab.D2.Is((L2, tca) => Math.Sqrt(L2) - tca))
            .Or("sphere: D² = L² + tca²", lab => lab.D2.Is((L2, tca) => L2 + tca * tca))
            .Or("sphere: D² = tca² − L²", lab => lab.D2.Is((L2, tca) => tca * tca - L2))
            .Or("sphere: thc = √(R² + D²)", lab => lab.Thc2.Is((R, D2) => R * R + D2)),
        new Mistake("thc-nosqrt", Affects.Spheres, Slides.Sphere, "sphere: thc = R² − D² without the root",
            lab => lab.Thc.Is(thc2 => thc2),
            "Spheres have the right outline, but bulge or are too flat: their light is wrong, and so is what covers them.",
            "In which unit is R² − D²: metres, or square metres?",
            "thc = √(R² − D²).")
            .Or("sphere: thc = R", lab => lab.Thc2.Is((R, _) => R * R))
            .Or("sphere: thc halved", lab => lab.Thc.Becomes(thc => thc2 => thc(thc2) / 2))
            .Or("sphere: thc doubled", lab => lab.Thc.Becomes(thc => thc2 => thc(thc2) * 2))
            .Or("sphere: thc = R − D", lab => lab.Thc2.Is((R, D2) => (R - Math.Sqrt(D2)) * (R - Math.Sqrt(D2))))
            .Or("sphere: (−b ∓ (b² − 4ac)) / 2a",
                lab => lab.Solution.Is((a, b, D) => D < 0 && !lab.NeverPassesBy ? None : Around(-b / (2 * a), D / (2 * a))))
            .Or("sphere: q = −(b ± (b² − 4ac)) / 2, t = q / a and c / q", lab => lab.Solution.Is((a, b, D) =>
            {
                if (D < 0 && !lab.NeverPassesBy) return None;
                var (q, c) = (-0.5 * (b > 0 ? b + D : b - D), (b * b - D) / (4 * a));
                return q / a < c / q ? new(q / a, c / q) : new(c / q, q / a);
            })),
        new Mistake("tca-only", Affects.Spheres, Slides.Sphere, "sphere: t = tca, where the ray is nearest to the centre",
            lab => lab.Roots.Is((tca, _) => new(tca)),
            "Spheres look like flat discs, and stand too deep in what they touch.",
            "What is at t = tca: the ray's way in, or its middle?",
            "t = tca − thc, and tca + thc if that does not count.")
            .Or("sphere: t = thc", lab => lab.Roots.Is((_, thc) => new(thc)))
            .Or("sphere: t = tca, and tca + thc if that does not count",
                lab => lab.Roots.Is((tca, thc) => new(tca, tca + thc))),
        new Mistake("r-diameter", Affects.Spheres | Affects.Circles, Slides.Sphere, "sphere: the radius taken for a diameter, R / 2",
            SphereRadius(R => R / 2),
            "Round things are half as large as they should be, or twice.",
            "How far is it from the centre to the rim?",
            "R is the scene's radius as it is.")
            .Or("sphere: 2 R", SphereRadius(R => R * 2))
            .Or("circle: R / 2", SurfaceMistakes.CircleRadius(R => R / 2))
            .Or("circle: 2 R", SurfaceMistakes.CircleRadius(R => R * 2))
            .Or("sphere and circle: R / 2", SphereRadius(R => R / 2) + SurfaceMistakes.CircleRadius(R => R / 2)),
    ];

    /// <summary>Another radius of spheres, from the right one.</summary>
    private static Action<Lab> SphereRadius(Func<double, double> R) =>
        lab => lab.Sphere.Becomes(cross => (s, d) => cross(s with { Radius = R((double)s.Radius) }, d));

    /// <summary>A ray that passes by a sphere hits it at NaN.</summary>
    private static Action<Lab> NoNumberHits(Func<double, double, bool> better) => lab =>
    {
        lab.NeverPassesBy = true;
        lab.Hit.Becomes(hit => (model, d) =>
            model is Model<Sphere> s && double.IsNaN(lab.Sphere.Do(s.Primitive, d).Near) ? double.NaN : hit(model, d));
        lab.Better.Is(better);
    };

    /// <summary>Another thc², without a question whether the ray passes by.</summary>
    private static Action<Lab> Unasked(Func<double, double, double> thc2) => lab =>
    {
        lab.NeverPassesBy = true;
        lab.Thc2.Is(thc2);
    };

    /// <summary>Other numbers for the 2 in b, the 4 in b² − 4ac and the 2 in / 2a, at most two of them wrong.</summary>
    private static IEnumerable<(string, Action<Lab>)> OtherFactors() =>
        from inB in (int[])[1, 2, 4]
        from inRoot in (int[])[1, 2, 4, -4]
        from under in (int[])[1, 2, 4]
        where (inB, inRoot, under) is not ((2, 4, 2) or (2, 1, 2) or (1, 1, 1)) && (inB, inRoot, under) is (2, _, _) or (_, 4, 2) or (1, 4, 1)
        select ($"sphere: b = {inB} d·(P − C), b² − {inRoot} a c, divided by {under} a", (Action<Lab>)(lab =>
        {
            if (inB != 2) lab.InB.Becomes(vector => (P, C) => inB / 2.0 * vector(P, C));
            if (inRoot != 4) lab.Discriminant.Is((a, b, c) => b * b - inRoot * a * c);
            if (under != 2) lab.Solution.Becomes(solution => (a, b, D) => solution(under / 2.0 * a, b, D));
        }));

    /// <summary>−b / 2a and what is taken from it and added to it → both crossings.</summary>
    private static Crossings<Scalar> Around(double middle, double half) => new(middle - half, middle + half);
}
