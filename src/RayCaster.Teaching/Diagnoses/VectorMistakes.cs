namespace RayCaster.Teaching;

/// <summary>In lengths, in products of vectors, and in what is not normalised.</summary>
internal static class VectorMistakes
{
    public static Mistake[] All =>
    [
        new Mistake("u-unnorm", Concerns.Camera, Slides.Camera, "U = up × W, not normalised",
            lab => lab.AxisU.Becomes(U => (up, w) => lab.Length.Do(lab.Cross.Do(up, w)) * U(up, w)),
            "The more the camera looks up or down, the more the picture is zoomed in.",
            "How long is up × W where they are not perpendicular?",
            "U = (up × W) normalised.")
            .In(ByInverse)
            .Or("U is normalised only after V = W × U",
                lab => lab.AxisV.Becomes(V => (w, u) => lab.Length.Do(lab.Cross.Do(lab.Camera.Up, w)) * V(w, u)))
            .Or("U is not normalised, but V is", Longer(false, lab => lab.Cross.Do(lab.Camera.Up, lab.W)))
            .Or("U = (up / |up|) × W, not normalised", Longer(true, lab => lab.Cross.Do(lab.Unit.Do(lab.Camera.Up), lab.W)))
            .Or("U = (up / |up|) × W, not normalised, but V is", Longer(false, lab => lab.Cross.Do(lab.Unit.Do(lab.Camera.Up), lab.W))),
        new Mistake("w-unnorm", Concerns.Camera, Slides.Camera, "W = −(T − P), not normalised",
            lab => lab.AxisW.Becomes(W => toTarget => lab.Length.Do(toTarget) * W(toTarget)),
            "Everything is drawn out, the more the farther the target is, or zFar has cut all of it away.",
            "The plane lies at distance |W| before the camera. How long is your W?",
            "W = −(T − P) normalised.")
            .In(ByInverse)
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
        new Mistake("norm-copy", Concerns.Camera, Slides.Vectors,
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
        new Mistake("len-nosqrt", Concerns.Camera, Slides.Vectors, "the length without its square root: |a| = x² + y² + z²",
            SquareLength + AllowAnyLength,
            "Nearly all is gone or has a wrong size, or the light reaches too far.",
            "How long is (3, 4, 0)? What does your Length say?",
            "|a| = √(x² + y² + z²).")
            .In([.. Lengths, ("triangles compare areas", ByAreas)])
            .Or("the same, with 2 · |T − P| for |2 (T − P)|", SquareLength + DoubleReach + AllowAnyLength)
            .Or("the same, while zNear and zFar are measured along (T − P) / |T − P|", SquareLength + DoubleReach + AllowAnyLength + RightDepth)
            .Or("the same, with t = |X − P|", SquareLength + DoubleReach + ByLength + AllowAnyLength)
            .Or("the same, with d = ux U + uy V − W / tan(fovY / 2) before it is normalised", SquareLength + DoubleReach + Zoom + AllowAnyLength)
            .Or("the length without its square root, but not in the camera's axes", SquareLength + RightAxes + AllowAnyLength)
            .Or("the same, with 2 · |T − P| for |2 (T − P)|", SquareLength + DoubleReach + RightAxes + AllowAnyLength)
            .Or("a vector is normalised by x² + y² + z²", Unit(a => a / (a * a)))
            .Or("the same, while zNear and zFar are measured along (T − P) / |T − P|", Unit(a => a / (a * a)) + RightDepth)
            .Or("the same, but not in the camera's axes", Unit(a => a / (a * a)) + RightAxes)
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
            .Or("the light reaches (T − P)²", lab => lab.Reach.Is(() => (lab.T - lab.P) * (lab.T - lab.P)))
            .Or("the light reaches 2 (T − P)²", lab => lab.Reach.Is(() => 2 * ((lab.T - lab.P) * (lab.T - lab.P))))
            .Or("the light reaches (2 (T − P))²", lab => lab.Reach.Is(() => 4 * ((lab.T - lab.P) * (lab.T - lab.P)))),
        new Mistake("cross-y", Concerns.Camera, Slides.Vectors, "the cross product's y has the wrong sign",
            Product((_, _, n) => n with { Y = -n.Y }) + ByCross[0].Deviate,
            "The picture is turned or skewed, and triangles are torn.",
            "What is (0, 0, 1) × (1, 0, 0)?",
            "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx).")
            .In(ByCross)
            .Or(CrossWordings(1, "ax bz − az bx"))
            .Or(Crosses("y and z are swapped", (_, _, n) => new(n.X, n.Z, n.Y)))
            .Or(Crosses("components have + for −", (a, b, n) => n + 2 * new Vector3(a.Z * b.Y, a.X * b.Z, a.Y * b.X)))
            .Or(Crosses("y and z have the wrong sign", (_, _, n) => new(n.X, -n.Y, -n.Z))),
        new Mistake("cross-z", Concerns.Camera, Slides.Vectors, "the cross product's z is ax by − ay by",
            Product((a, b, n) => n with { Z = a.X * b.Y - a.Y * b.Y }) + ByCross[0].Deviate,
            "The picture is skewed, and triangles are torn.",
            "What is (1, 2, 0) × (3, 5, 0)?",
            "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx).")
            .In(ByCross)
            .Or(CrossWordings(2, "ax by − ay by"))
            .Or(Crosses("x and z are swapped", (_, _, n) => new(n.Z, n.Y, n.X)))
            .Or(Crosses("x and z have the wrong sign", (_, _, n) => new(-n.X, n.Y, -n.Z))),
        new Mistake("dir-unnorm", Concerns.Camera, Slides.PixelTranslation, "d not normalised",
            LeaveDirection + AllowAnyLength,
            "The borders of the picture are too bright; all places are right.",
            "t is a distance only if d has a certain length. Which?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d = ux U + uy V − W / tan(fovY / 2), not normalised", LeaveDirection + AllowAnyLength + Zoom),
        new Mistake("dir-unnorm-a1", Concerns.Camera, Slides.Sphere, "d not normalised, while the sphere takes d·d = 1",
            LeaveDirection + AssumeUnitLength,
            "Spheres bleed into wedges towards the borders, which are too bright.",
            "The sphere's formula left out a = d·d. When is that allowed?",
            "d = (uc U + ur V − W) normalised.")
            .Or("d = ux U + uy V − W / tan(fovY / 2), not normalised", LeaveDirection + AssumeUnitLength + Zoom)
            .Or("d not normalised, while the sphere takes d·d = 1 and the light fades with |X − P|", LeaveDirection + AssumeUnitLength + ByLength)
            .Or("d not normalised, while the sphere takes d·d = 1 and D = L − tca d", LeaveDirection + FromTheRay)
            .In(Lengths),
        new Mistake("cross-x", Concerns.Camera, Slides.Vectors, "the cross product's x has the wrong sign",
            Product((_, _, n) => n with { X = -n.X }) + ByCross[0].Deviate,
            "The picture is mirrored, turned or skewed, and triangles are torn.",
            "What is (0, 1, 0) × (0, 0, 1)?",
            "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx).")
            .In(ByCross)
            .Or(CrossWordings(0, "az by − ay bz"))
            .Or(Crosses("x and y are swapped", (_, _, n) => new(n.Y, n.X, n.Z)))
            .Or(Crosses("x and y have the wrong sign", (_, _, n) => new(-n.X, -n.Y, n.Z)))
            .Or(Crosses("components have moved on by one place", (_, _, n) => new(n.Y, n.Z, n.X)))
            .Or(Crosses("components have moved back by one place", (_, _, n) => new(n.Z, n.X, n.Y))),
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
    private static (string Name, Func<Vector3, Vector3, Vector3> Of)[] Parts =>
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
        ("circles ask |X − C| ≤ R with it", SurfaceMistakes.CircleWhere((lab, circle, X) => lab.Length.Do(X - circle.Center) <= circle.Radius)),
        ("circles count along two axes of their own", InCircleAxes(turned: false)),
        ("the light fades with |X − P|", ByLength),
        ("zNear and zFar measure |X − P|", ClipByLength),
        ByInverse,
    ];

    /// <summary>Circles ask x² + y² ≤ R² along two axes in their plane, made with the cross product.</summary>
    /// <param name="turned">Whether n comes first in the product for the first of them.</param>
    private static Action<Lab> InCircleAxes(bool turned) => SurfaceMistakes.CircleWhere((lab, circle, X) =>
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
        if (lab.Camera.Clip == Clip.Depth) return;
        lab.Depth.Is((t, d) => lab.Length.Do(t * d));
        lab.Near.Becomes(near => (_, length) => near(length, length));
        lab.Far.Becomes(far => (_, length) => far(length, length));
    }

    private static Action<Lab> SquareLength => lab => lab.Length.Becomes(length => a => length(a) * length(a));

    /// <summary>Twice the length, where the length of twice the vector is another.</summary>
    private static Action<Lab> DoubleReach => lab => lab.Reach.Is(() => 2 * lab.Length.Do(lab.T - lab.P));

    /// <summary>The sphere's formula for a direction of any length: t counts in its lengths.</summary>
    private static Action<Lab> AllowAnyLength => lab => lab.Sphere.Is((s, d) =>
    {
        var length = d.Length;
        var crossed = lab.SphereBySteps(s, d / length);
        return new(crossed.Near / length, crossed.Far / length);
    });

    /// <summary>The slide's geometric formula for d·d = 1, with any d: the same as the analytic one with a = 1.</summary>
    private static Action<Lab> AssumeUnitLength => lab => lab.Sphere.Is((sphere, d) => lab.Geometric(sphere, d));

    private static Action<Lab> FromTheRay => lab => lab.Sphere.Is((sphere, d) => lab.Geometric(sphere, d, fromTheRay: true));

    /// <summary>d by the inverse of the matrix with the rows U, V and W: another right way if these are perpendicular and of length 1.</summary>
    internal static (string Cause, Action<Lab> Deviate) ByInverse => ("d is made by the inverse of the matrix with the rows U, V and W", lab =>
        lab.Towards.Is((uc, ur) => (uc * (lab.V % lab.W) + ur * (lab.W % lab.U) - lab.U % lab.V) / (lab.U % lab.V * lab.W)));

    /// <summary>A component with other letters, with other signs, or with a term forgotten.</summary>
    private static IEnumerable<(string, Action<Lab>)> CrossWordings(int own, string usual)
    {
        const string axes = "xyz";
        var (i, k) = ((own + 1) % 3, (own + 2) % 3);
        int[][] letters =
        [
            [k, i, i, k], [own, k, k, own], [i, own, own, i], // where a_i b_k − a_k b_i is right
            .. from place in (int[])[0, 1, 2, 3]
               from turn in (int[])[1, 2]
               select ((int[])[i, k, k, i]).Select((letter, at) => at == place ? (letter + turn) % 3 : letter).ToArray(),
        ];
        (string Is, Func<Vector3, Vector3, double> Of)[] slips =
        [
            .. from l in letters
               select ($"a{axes[l[0]]} b{axes[l[1]]} − a{axes[l[2]]} b{axes[l[3]]}",
                   (Func<Vector3, Vector3, double>)((a, b) => a.At(l[0]) * b.At(l[1]) - a.At(l[2]) * b.At(l[3]))),
            .. from signs in ((int First, int Last)[])[(1, 1), (-1, -1), (1, 0), (0, -1), (0, 0)]
               select ($"{signs.First} · a{axes[i]} b{axes[k]} + {signs.Last} · a{axes[k]} b{axes[i]}",
                   (Func<Vector3, Vector3, double>)((a, b) => signs.First * a.At(i) * b.At(k) + signs.Last * a.At(k) * b.At(i))),
        ];
        return from way in Enumerable.Range(0, 12) // so that of those that draw the same each slip comes once before it comes again
               from slip in slips
               where way > 0 || slip.Is != usual
               select Crosses($"{axes[own]} is {slip.Is}", (a, b, n) => slip.Of(a, b) is var c ? Parts[own].Of(new(c, c, c), n) : n)[way];
    }

    /// <summary>Another cross product, from a, b and a × b: in the slide's formulas, in the camera alone, in each way to the camera's axes that uses
    /// it, and in shapes alone.</summary>
    private static (string, Action<Lab>)[] Crosses(string which, Func<Vector3, Vector3, Vector3, Vector3> other)
    {
        var wrong = Product(other);
        var forwards = wrong + (lab =>
        {
            lab.AxisU.Is((up, w) => lab.Unit.Do(lab.Cross.Do(-w, up)));
            lab.AxisV.Is((w, u) => lab.Cross.Do(u, -w));
        });
        return
        [
            ($"the cross product's {which}", wrong + ByCross[0].Deviate),
            ($"the cross product's {which}, but triangles do without it", wrong),
            ($"the cross product's {which}; U = (T − P) × up, V = U × (T − P)", forwards),
            ($"the cross product's {which}; the same, and {ByInverse.Cause}", forwards + ByInverse.Deviate),
            ($"the cross product's {which}; {ByInverse.Cause}", wrong + ByInverse.Deviate),
            ($"the cross product's {which}; V is up without its part along W, U = V × W", wrong + ProjectUp),
            ($"the cross product's {which}; the camera turned by two angles, from axes made with it", wrong + TurnByAngles),
            ($"the cross product's {which}; the camera turned by yaw and pitch, and rolled by an angle made with it", wrong + Roll),
            .. from manner in ByCross.Take(4)
               select ($"the cross product's {which}, not in the camera; {manner.Cause}", wrong + RightAxes + manner.Deviate),
        ];
    }

    private static Action<Lab> Product(Func<Vector3, Vector3, Vector3, Vector3> other) =>
        lab => lab.Cross.Becomes(cross => (a, b) => other(a, b, cross(a, b)));

    /// <summary>Other right ways to write the formulas that use a cross product: in each a wrong one shows otherwise.</summary>
    private static (string Cause, Action<Lab> Deviate)[] ByCross =>
    [
        ("triangles compare areas along n", Triangles((lab, triangle, d) => lab.TriangleByShares(triangle, d, lab.Cross.Do))),
        ("triangles take only n from it", Triangles((lab, triangle, d) => lab.TriangleByShares(triangle, d, (a, b) => a % b))),
        ("circles count along two axes of their own", InCircleAxes(turned: false)),
        ("circles count along two axes of their own, n × x first", InCircleAxes(turned: true)),
        ("triangles compare volumes", Triangles((lab, triangle, d) => lab.TriangleByVolumes(triangle, d))),
        ("triangles compare volumes and take t from them", Triangles((lab, triangle, d) => lab.TriangleByVolumes(triangle, d, tFromCorners: true))),
        ("triangles compare determinants", Triangles((lab, triangle, d) => lab.TriangleByDeterminants(triangle, d))),
        ("triangles compare areas", ByAreas),
        ("triangles compare areas seen from X", Triangles((lab, triangle, d) => lab.TriangleByAreas(triangle, d, 1e-9, fromX: true))),
        ("triangles take n and (P − A) × d", Triangles((lab, triangle, d) => lab.TriangleByRay(triangle, d))),
        ByInverse,
        ("triangles compare sides", Triangles((lab, triangle, d) => lab.TriangleBySides(triangle, d, byNormal: false))),
        ("triangles compare sides with n", Triangles((lab, triangle, d) => lab.TriangleBySides(triangle, d, byNormal: true))),
        ("triangles are asked in two of x, y and z", Triangles((lab, triangle, d) => lab.TriangleFlattened(triangle, d))),
    ];

    private static Action<Lab> Triangles(Func<Lab, Triangle, Vector3, Crossings<Scalar>> cross) =>
        lab => lab.TriangleIs((triangle, d) => cross(lab, triangle, d));

    /// <summary>V = up − (up·W) W normalised, and U = V × W: another way to the same axes.</summary>
    private static void ProjectUp(Lab lab)
    {
        lab.AxisV.Is((w, _) => lab.Unit.Do(lab.Camera.Up - (lab.Camera.Up * w) * w));
        lab.AxisU.Is((_, w) => lab.Cross.Do(lab.AxisV.Do(w, default), w));
    }

    /// <summary>The camera turned to the right and up in a frame whose third axis is up: another way to the same axes.</summary>
    private static void TurnByAngles(Lab lab)
    {
        var up = lab.Unit.Do(lab.Camera.Up);
        var x = lab.Unit.Do(lab.Cross.Do(Math.Abs(up.X) < 0.9 ? new(1, 0, 0) : new(0, 1, 0), up));
        var (y, f) = (lab.Cross.Do(up, x), lab.T - lab.P);
        var (yaw, pitch) = (Math.Atan2(f * y, f * x), Math.Asin(f * up / f.Length));
        var level = Math.Cos(yaw) * x + Math.Sin(yaw) * y;
        lab.AxisW.Is(_ => -(Math.Cos(pitch) * level + Math.Sin(pitch) * up));
        lab.AxisU.Is((_, _) => Math.Sin(yaw) * x - Math.Cos(yaw) * y);
        lab.AxisV.Is((_, _) => Math.Cos(pitch) * up - Math.Sin(pitch) * level);
    }

    /// <summary>V from yaw and pitch by a cross product, then U and V turned by the roll: another way to the same axes.</summary>
    private static void Roll(Lab lab)
    {
        var (f, up) = (lab.T - lab.P, lab.Camera.Up);
        var (yaw, pitch) = (Math.Atan2(f.Y, f.X), Math.Atan2(f.Z, Math.Sqrt(f.X * f.X + f.Y * f.Y)));
        Vector3 forward = new(Math.Cos(pitch) * Math.Cos(yaw), Math.Cos(pitch) * Math.Sin(yaw), Math.Sin(pitch));
        Vector3 right = new(Math.Sin(yaw), -Math.Cos(yaw), 0);
        var above = lab.Cross.Do(right, forward);
        var roll = Math.Atan2(up * right, up * above);
        lab.AxisW.Is(_ => -forward);
        lab.AxisU.Is((_, _) => Math.Cos(roll) * right - Math.Sin(roll) * above);
        lab.AxisV.Is((_, _) => Math.Sin(roll) * right + Math.Cos(roll) * above);
    }

    /// <summary>The camera's axes without the wrong cross product or length.</summary>
    private static void RightAxes(Lab lab)
    {
        lab.AxisW.Is(toTarget => -toTarget.Normalized);
        lab.AxisU.Is((up, w) => (up % w).Normalized);
        lab.AxisV.Is((w, u) => w % u);
    }

    private static Action<Lab> ByAreas => lab => lab.TriangleIs((triangle, d) => lab.TriangleByAreas(triangle, d, 1e-9));
}
