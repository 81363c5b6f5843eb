namespace RayCaster.Teaching;

/// <summary>In lengths, in products of vectors, and in what is not normalised.</summary>
internal static class VectorMistakes
{
    public static Mistake[] All =>
    [
        new("u-unnorm", Affects.Camera, Slides.Camera, "U = up × W, not normalised",
            lab => lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w)),
            "The more the camera looks up or down, the more the picture is zoomed in.",
            "How long is up × W where they are not perpendicular?",
            "U = (up × W) normalised."),
        new("w-unnorm", Affects.Camera, Slides.Camera, "W = −(T − P), not normalised",
            lab => lab.AxisW.Becomes(W => toTarget => lab.Length.Do(toTarget) * W(toTarget)),
            "Everything is drawn out, the more the farther the target is, or zFar has cut all of it away.",
            "The plane lies at distance |W| before the camera. How long is your W?",
            "W = −(T − P) normalised."),
        new("norm-copy", Affects.Camera, Slides.Vectors, "W, U and d are not normalised: Normalize() changes a copy, or its result is not used",
            LeaveAxes + LeaveDirection + AllowAnyLength,
            "Everything is far too large and far too bright: a piece of it fills the picture.",
            "Print |W|, |U| and |d|. What should they be?",
            "A vector's method returns a new vector: d = d.Normalized."),
        new Mistake("len-nosqrt", Affects.Camera, Slides.Vectors, "the length without its square root: |a| = x² + y² + z²",
            AllowAnyLength + SquareLength,
            "Nearly all is gone or has a wrong size, or the light reaches too far.",
            "How long is (1, 2, 2)? What does your Length say?",
            "|a| = √(x² + y² + z²).")
            .Or(SquareLengths),
        OfCross("cross-y", "the cross product's y has the wrong sign", (_, _, n) => n with { Y = -n.Y },
            "The picture is turned or skewed, and triangles are torn.",
            "What is (0, 0, 1) × (1, 0, 0)?"),
        OfCross("cross-z", "the cross product's z is ax by − ay by", (a, b, n) => n with { Z = a.X * b.Y - a.Y * b.Y },
            "The picture is skewed, and triangles are torn.",
            "What is (1, 2, 0) × (3, 5, 0)?"),
        new("dir-unnorm", Affects.Camera, Slides.PixelTranslation, "d not normalised",
            LeaveDirection + AllowAnyLength,
            "The borders of the picture are too bright; all places are right.",
            "t is a distance only if d has a certain length. Which?",
            "d = (uc U + ur V − W) normalised."),
        new Mistake("dir-unnorm-a1", Affects.Camera, Slides.Sphere, "d not normalised, while the sphere takes d·d = 1",
            LeaveDirection + Geometric((_, L, t_ca, _) => L * L - t_ca * t_ca),
            "Spheres bleed into wedges towards the borders, which are too bright.",
            "The sphere's formula left out a = d·d. When is that allowed?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d not normalised, while the sphere takes d·d = 1 and D = L − t_ca d",
                LeaveDirection + Geometric((_, L, t_ca, d) => (L - t_ca * d) * (L - t_ca * d))),
        OfCross("cross-x", "the cross product's x has the wrong sign", (_, _, n) => n with { X = -n.X },
            "The picture is mirrored, turned or skewed, and triangles are torn.",
            "What is (0, 1, 0) × (0, 0, 1)?"),
    ];

    /// <summary>Another cross product, from a, b and a × b, in all formulas.</summary>
    private static Mistake OfCross(string id, string cause, Func<Vector3, Vector3, Vector3, Vector3> other, string symptom, string question) => new(
        id, Affects.Camera, Slides.Vectors, cause,
        lab =>
        {
            lab.Cross.Becomes(cross => (a, b) => other(a, b, cross(a, b)));
            lab.TriangleByShares();
        },
        symptom, question, "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx).");

    private static double Square(double x) => x * x;

    private static Action<Lab> SquareLength => lab => lab.Length.Becomes(length => a => length(a) * length(a));

    /// <summary>A length is in several formulas at once, in each as it is written there: an edit in one style comes nowhere near.</summary>
    private static IEnumerable<(string Cause, Action<Lab> Deviate)> SquareLengths
    {
        get
        {
            (string Words, Action<Lab> Sphere)[] spheres =
            [
                ("", AllowAnyLength), (", while the sphere takes d·d = 1", Geometric((_, L, t_ca, _) => L * L - t_ca * t_ca)),
                (", while the sphere takes D = |L − t_ca d|", Geometric((lab, L, t_ca, d) => Square(lab.Length.Do(L - t_ca * d)))),
            ];
            (string Words, Action<Lab> Light)[] lights =
            [
                ("", _ => { }), (", with 2 · |T − P| for |2 (T − P)|", DoubleReach),
                (", with 2 · |T − P| for |2 (T − P)| and t = |X − P|", DoubleReach + (lab => lab.Distance.Is((t, d) => lab.Length.Do(t * d)))),
            ];
            (string Words, Action<Lab> Circle)[] circles = [("", _ => { }), (", while circles test |X − C| ≤ R with it", CircleByLength)];
            return
            [
                .. (from light in lights from sphere in spheres from circle in circles
                    select ($"the length without its square root{light.Words}{sphere.Words}{circle.Words}",
                        SquareLength + sphere.Sphere + light.Light + circle.Circle)).Skip(1), // the first is the usual one
                .. from sphere in spheres[..2]
                   select ($"a vector is normalised by x² + y² + z²{sphere.Words}", sphere.Sphere + (lab => lab.Unit.Is(a => a / (a * a)))),
            ];
        }
    }

    /// <summary>Twice the length, where the length of twice the vector is another.</summary>
    private static Action<Lab> DoubleReach => lab => lab.FadeDistance.Is(() => 2 * lab.Length.Do(lab.T - lab.P));

    private static Action<Lab> CircleByLength => lab => lab.Circle.Is((circle, d) =>
    {
        var t = (circle.Center - lab.P) * circle.Normal / (circle.Normal * d);
        return lab.Length.Do(lab.P + t * d - circle.Center) <= circle.Radius ? new(t) : SlideFormulas.None;
    });

    private static Action<Lab> LeaveDirection => lab => lab.Direction.Is(d => d);

    private static Action<Lab> LeaveAxes => lab =>
    {
        lab.AxisW.Becomes(W => toTarget => lab.Length.Do(toTarget) * W(toTarget));
        lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w));
    };

    /// <summary>The sphere's formula for a direction of any length: t counts in its lengths.</summary>
    private static Action<Lab> AllowAnyLength => lab => lab.Sphere.Becomes(cross => (s, d) =>
    {
        var length = d.Length;
        var crossed = cross(s, d / length);
        return new(crossed.Near / length, crossed.Far / length);
    });

    /// <summary>The slide's sphere, for d·d = 1.</summary>
    /// <param name="DSquare">(lab, L, t_ca, d) → D².</param>
    private static Action<Lab> Geometric(Func<Lab, Vector3, double, Vector3, double> DSquare) => lab => lab.Sphere.Is((s, d) =>
    {
        var L = s.Center - lab.P;
        var t_ca = L * d;
        var t_hc = Math.Sqrt((double)s.Radius * s.Radius - DSquare(lab, L, t_ca, d)); // NaN where the ray misses the sphere
        return new(t_ca - t_hc, t_ca + t_hc);
    });
}
