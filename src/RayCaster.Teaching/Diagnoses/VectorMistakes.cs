namespace RayCaster.Teaching;

/// <summary>In lengths, in products of vectors, and in what is not normalised.</summary>
internal static class VectorMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("u-unnorm", Affects.Camera, Slides.Camera, "U = up × W, not normalised",
            lab => lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w)),
            "The more the camera looks up or down, the more the picture is zoomed in.",
            "How long is up × W where they are not perpendicular?",
            "U = (up × W) normalised.")
            .In(CameraWays.ByInverse)
            .Or("U is normalised only after V = W × U",
                lab => lab.AxisV.Becomes(V => (w, u) => lab.Length.Do(lab.Cross.Do(lab.Camera.Up, w)) * V(w, u)))
            .Or("U is not normalised, but V is", Longer(false, lab => lab.Cross.Do(lab.Camera.Up, lab.W)))
            .Or("U = (up / |up|) × W, not normalised", Longer(true, lab => lab.Cross.Do(lab.Unit.Do(lab.Camera.Up), lab.W)))
            .Or("U = (up / |up|) × W, not normalised, but V is", Longer(false, lab => lab.Cross.Do(lab.Unit.Do(lab.Camera.Up), lab.W))),
        new Mistake("w-unnorm", Affects.Camera, Slides.Camera, "W = −(T − P), not normalised",
            lab => lab.AxisW.Becomes(W => toTarget => lab.Length.Do(toTarget) * W(toTarget)),
            "Everything is drawn out, the more the farther the target is, or zFar has cut all of it away.",
            "The plane lies at distance |W| before the camera. How long is your W?",
            "W = −(T − P) normalised.")
            .In(CameraWays.ByInverse)
            .Or("W is not normalised in d alone", LengthenW)
            .Or("W is not normalised in V alone", lab => lab.AxisV.Becomes(V => (w, u) => lab.Length.Do(lab.T - lab.P) * V(w, u)))
            .Or("h and w are those at the target, while W is normalised",
                lab => lab.PlaneHeight.Becomes(h => fovY => lab.Length.Do(lab.T - lab.P) * h(fovY)))
            .Or("h and w are those at zNear, while W is normalised",
                lab => lab.PlaneHeight.Becomes(h => fovY => lab.Camera.ZNear * h(fovY)))
            .Or("d = uc U + ur V − zNear W, while h and w are those at 1",
                lab => lab.PlaneHeight.Becomes(h => fovY => h(fovY) / lab.Camera.ZNear))
            .Or(from up in ((string Name, Func<Lab, Vector3> Of)[])[("up", lab => lab.Camera.Up), ("up / |up|", lab => lab.Unit.Do(lab.Camera.Up))]
                from alsoV in (bool[])[false, true]
                select ($"U = {up.Name} × (P − T){(alsoV ? ", V = W × U" : ", and V is normalised")}",
                    Longer(alsoV, lab => lab.Cross.Do(up.Of(lab), lab.P - lab.T))))
            .Or("V = (T − P) × U", lab => lab.AxisV.Becomes(V => (w, u) => -lab.Length.Do(lab.T - lab.P) * V(w, u))),
        new Mistake("norm-copy", Affects.Camera, Slides.Vectors,
            "W, U and d are not normalised: Normalize() changes a copy, or its result is not used",
            LeaveAll + AllowAnyLength,
            "Everything is far too large and far too bright: a piece of it fills the picture.",
            "Print |W|, |U| and |d|. What should they be?",
            "A vector's method returns a new vector: d = d.Normalized.")
            .In(Lengths)
            .Or("W, U and d = ux U + uy V − W / tan(fovY / 2) are not normalised", LeaveAll + Zoom + AllowAnyLength)
            .Or("W, U and d are not normalised, but where zNear and zFar are measured", LeaveAll + AllowAnyLength + RightDepth)
            .Or("W and U are not normalised", LeaveAxes)
            .Or(from part in Parts
                from unit in (Func<Vector3, Vector3>[])[a => part.Of(a / a.Length, a), a => part.Of(a, a / a.Length)]
                select ($"normalised in {part.Name} alone", Unit(unit)))
            .Or(from part in Parts
                select ($"d normalised, but not its {part.Name}",
                    (Action<Lab>)(lab => lab.Direction.Is(d => part.Of(d, d / d.Length))) + AllowAnyLength))
            .Or("each component divided by a length that has changed by then", Unit(a =>
            {
                a = a with { X = a.X / a.Length };
                a = a with { Y = a.Y / a.Length };
                return a with { Z = a.Z / a.Length };
            }))
            .Or("a |a| for a / |a|", Unit(a => a.Length * a)),
        new Mistake("len-nosqrt", Affects.Camera, Slides.Vectors, "the length without its square root: |a| = x² + y² + z²",
            SquareLength + AllowAnyLength,
            "Nearly all is gone or has a wrong size, or the light reaches too far.",
            "How long is (1, 2, 2)? What does your Length say?",
            "|a| = √(x² + y² + z²).")
            .In([.. Lengths, ("triangles compare areas", ByAreas)])
            .Or("the same, with 2 · |T − P| for |2 (T − P)|", SquareLength + DoubleReach + AllowAnyLength)
            .Or("the same, while zNear and zFar are measured along (T − P) / |T − P|", SquareLength + DoubleReach + AllowAnyLength + RightDepth)
            .Or("the same, with t = |X − P|", SquareLength + DoubleReach + ByLength + AllowAnyLength)
            .Or("the same, with d = ux U + uy V − W / tan(fovY / 2) before it is normalised", SquareLength + DoubleReach + Zoom + AllowAnyLength)
            .Or("the length without its square root, but not in the camera's axes", SquareLength + CameraWays.RightAxes + AllowAnyLength)
            .Or("the same, with 2 · |T − P| for |2 (T − P)|", SquareLength + DoubleReach + CameraWays.RightAxes + AllowAnyLength)
            .Or("a vector is normalised by x² + y² + z²", Unit(a => a / (a * a)))
            .Or("the same, while zNear and zFar are measured along (T − P) / |T − P|", Unit(a => a / (a * a)) + RightDepth)
            .Or("the same, but not in the camera's axes", Unit(a => a / (a * a)) + CameraWays.RightAxes)
            .Or(from part in Parts select ($"{part.Name} forgotten in the length", Length(a => part.Of(Vector3.Zero, a).Length)))
            .Or(from k in (int[])[0, 1, 2]
                select ($"|a| with {"xyz"[k]} for {"xyz"[k]}²", Length(a => Math.Sqrt(a * a - a.At(k) * a.At(k) + a.At(k)))))
            .Or("|a| = |x| + |y| + |z|", Length(a => Math.Abs(a.X) + Math.Abs(a.Y) + Math.Abs(a.Z)))
            .Or("|a| = (x² + y² + z²) / 2", Length(a => a * a / 2))
            .Or("|a| with its root taken twice", Length(a => Math.Sqrt(a.Length)))
            .Or("|a| = √(x² + y²) + z²", Length(a => Math.Sqrt(a.X * a.X + a.Y * a.Y) + a.Z * a.Z))
            .Or(from k in (int[])[0, 1, 2]
                from letters in (int[])[1, 2, 4, 8] // one of both replaced by the next or by the last letter, or both
                let l = letters < 3 ? k : (k + letters / 4) % 3
                let m = (k + (letters < 3 ? letters : letters / 4)) % 3
                select ($"|a| with {"xyz"[l]} {"xyz"[m]} for {"xyz"[k]}²", Length(a => Math.Sqrt(a * a - a.At(k) * a.At(k) + a.At(l) * a.At(m)))))
            .Or("d is divided by x² + y² + z²", AllowAnyLength + (lab => lab.Direction.Is(d => d / (d * d))))
            .Or("d = ux U + uy V − W / tan(fovY / 2) is divided by x² + y² + z²",
                AllowAnyLength + Zoom + (lab => lab.Direction.Is(d => d / (d * d))))
            .Or("the light reaches (T − P)²", lab => lab.FadeDistance.Is(() => (lab.T - lab.P) * (lab.T - lab.P)))
            .Or("the light reaches 2 (T − P)²", lab => lab.FadeDistance.Is(() => 2 * ((lab.T - lab.P) * (lab.T - lab.P))))
            .Or("the light reaches (2 (T − P))²", lab => lab.FadeDistance.Is(() => 4 * ((lab.T - lab.P) * (lab.T - lab.P)))),
        CrossMistakes.OfY,
        CrossMistakes.OfZ,
        new Mistake("dir-unnorm", Affects.Camera, Slides.PixelTranslation, "d not normalised",
            LeaveDirection + AllowAnyLength,
            "The borders of the picture are too bright; all places are right.",
            "t is a distance only if d has a certain length. Which?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d = ux U + uy V − W / tan(fovY / 2), not normalised", LeaveDirection + AllowAnyLength + Zoom),
        new Mistake("dir-unnorm-a1", Affects.Camera, Slides.Sphere, "d not normalised, while the sphere takes d·d = 1",
            LeaveDirection + AssumeUnitLength,
            "Spheres bleed into wedges towards the borders, which are too bright.",
            "The sphere's formula left out a = d·d. When is that allowed?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d = ux U + uy V − W / tan(fovY / 2), not normalised", LeaveDirection + AssumeUnitLength + Zoom)
            .Or("d not normalised, while the sphere takes d·d = 1 and the light fades with |X − P|", LeaveDirection + AssumeUnitLength + ByLength)
            .Or("d not normalised, while the sphere takes d·d = 1 and D = L − tca d", LeaveDirection + FromTheRay)
            .In(Lengths),
        CrossMistakes.OfX,
    ];

    /// <summary>U, or U and V, as long as a vector is.</summary>
    private static Action<Lab> Longer(bool alsoV, Func<Lab, Vector3> vector) => lab => lab.Towards.Becomes(towards => (uc, ur) =>
        lab.Length.Do(vector(lab)) is var length ? towards(uc * length, alsoV ? ur * length : ur) : default);

    /// <summary>uc U + ur V − |T − P| W.</summary>
    private static void LengthenW(Lab lab) => lab.Towards.Becomes(towards => (uc, ur) =>
        lab.Length.Do(lab.T - lab.P) is var length ? length * towards(uc / length, ur / length) : default);

    private static Action<Lab> LeaveDirection => lab => lab.Direction.Is(d => d);

    private static Action<Lab> LeaveAll => LeaveAxes + LeaveDirection;

    /// <summary>d for a plane of the height 2 at the distance 1 / tan(fovY / 2), not normalised yet; backwards where that is negative.</summary>
    internal static Action<Lab> Zoom => lab => lab.Towards.Becomes(towards => (uc, ur) => towards(uc, ur) / lab.HalfHeight);

    private static void LeaveAxes(Lab lab)
    {
        lab.AxisW.Becomes(W => toTarget => lab.Length.Do(toTarget) * W(toTarget));
        lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w));
    }

    /// <summary>A vector whose other components come from a second one, by the component that does not.</summary>
    internal static (string Name, Func<Vector3, Vector3, Vector3> Of)[] Parts =>
    [
        ("x", (b, a) => a with { X = b.X }), ("y", (b, a) => a with { Y = b.Y }), ("z", (b, a) => a with { Z = b.Z }),
    ];

    /// <summary>Another way to normalise.</summary>
    private static Action<Lab> Unit(Func<Vector3, Vector3> unit) => AllowAnyLength + (lab => lab.Unit.Is(unit));

    /// <summary>Another length.</summary>
    private static Action<Lab> Length(Func<Vector3, double> length) => AllowAnyLength + DoubleReach + (lab => lab.Length.Is(length));

    internal static Action<Lab> RightDepth => lab => lab.Depth.Is((t, d) => t * (d * (lab.T - lab.P).Normalized));

    /// <summary>Other right ways to write the formulas that use a length or d: in each a wrong length shows otherwise.</summary>
    private static (string, Action<Lab>)[] Lengths =>
    [
        ("the sphere takes d·d = 1", AssumeUnitLength),
        ("the sphere takes d·d = 1 and D = L − tca d", FromTheRay),
        ("the sphere takes d·d = 1 and D² = L² (1 − cos²), not below 0", AssumeUnitLength + (lab =>
            lab.D2.Becomes(D2 => (L2, tca) => Math.Max(0, D2(L2, tca))))),
        SphereByCross,
        OriginMistakes.FromNear,
        ("the depth is t / √(1 + x² + y²), with x = d·U / d·W and y = d·V / d·W", lab => lab.Depth.Is((t, d) =>
            t / new Vector3(d * lab.U / (d * lab.W), d * lab.V / (d * lab.W), 1).Length)),
        ("circles ask |X − C| ≤ R with it", SurfaceMistakes.CircleWhere((lab, circle, X) => lab.Length.Do(X - circle.Center) <= circle.Radius)),
        ("circles count along two axes of their own", InCircleAxes(turned: false)),
        ("the light fades with |X − P|", ByLength),
        ("zNear and zFar measure |X − P|", ClipByLength),
        CameraWays.ByInverse,
    ];

    internal static (string Cause, Action<Lab> Deviate) SphereByCross => ("the sphere takes d·d = 1 and D = L × d",
        lab => lab.Sphere.Is((sphere, d) => lab.Geometric(sphere, d, (L, _) => lab.Cross.Do(L, d))));

    /// <summary>Circles ask x² + y² ≤ R² along two axes in their plane, made with the cross product.</summary>
    /// <param name="turned">Whether n comes first in the product for the first of them.</param>
    internal static Action<Lab> InCircleAxes(bool turned) => SurfaceMistakes.CircleWhere((lab, circle, X) =>
    {
        var n = lab.Unit.Do(circle.Normal);
        Vector3 other = Math.Abs(n.X) < 0.8 ? new(1, 0, 0) : new(0, 1, 0);
        var axis = lab.Unit.Do(turned ? lab.Cross.Do(n, other) : lab.Cross.Do(other, n));
        var (x, y) = ((X - circle.Center) * axis, (X - circle.Center) * lab.Cross.Do(n, axis));
        return x * x + y * y <= circle.Radius * circle.Radius;
    });

    /// <summary>The light fades with |X − P|, where X − P = t d.</summary>
    internal static Action<Lab> ByLength => lab => lab.Distance.Is((t, d) => lab.Length.Do(t * d));

    /// <summary>zNear and zFar, where they measure the distance, are compared with |X − P|, where X − P = t d.</summary>
    private static void ClipByLength(Lab lab)
    {
        if (lab.Camera.Clip == ClipMode.Depth) return;
        lab.Depth.Is((t, d) => lab.Length.Do(t * d));
        lab.Near.Becomes(near => (_, length) => near(length, length));
        lab.Far.Becomes(far => (_, length) => far(length, length));
    }

    private static Action<Lab> SquareLength => lab => lab.Length.Becomes(length => a => length(a) * length(a));

    /// <summary>Twice the length, where the length of twice the vector is another.</summary>
    private static Action<Lab> DoubleReach => lab => lab.FadeDistance.Is(() => 2 * lab.Length.Do(lab.T - lab.P));

    /// <summary>The sphere's formula for a direction of any length: t counts in its lengths.</summary>
    private static Action<Lab> AllowAnyLength => lab => lab.Sphere.Is((s, d) =>
    {
        var length = d.Length;
        var crossed = lab.SphereBySteps(s, d / length);
        return new(crossed.Near / length, crossed.Far / length);
    });

    /// <summary>The slide's geometric formula for d·d = 1, with any d: the same as the analytic one with a = 1.</summary>
    private static Action<Lab> AssumeUnitLength => lab => lab.Sphere.Is((sphere, d) => lab.Geometric(sphere, d));

    private static Action<Lab> FromTheRay => lab => lab.Sphere.Is((sphere, d) => lab.Geometric(sphere, d, (L, tca) => L - tca * d));

    internal static Action<Lab> ByAreas => lab => lab.TriangleIs((triangle, d) => lab.TriangleByAreas(triangle, d, 1e-9));
}
