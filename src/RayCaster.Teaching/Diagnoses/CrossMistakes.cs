namespace RayCaster.Teaching;

/// <summary>In the cross product.</summary>
internal static class CrossMistakes
{
    public static Mistake OfY => Of("cross-y", 1, "ax bz − az bx", "the cross product's y has the wrong sign", (_, _, n) => n with { Y = -n.Y },
        "The picture is turned or skewed, and triangles are torn.",
        "What is (0, 0, 1) × (1, 0, 0)?")
        .Or(Crosses("y and z are swapped", (_, _, n) => new(n.X, n.Z, n.Y)))
        .Or(Crosses("components have + for −", (a, b, n) => n + 2 * new Vector3(a.Z * b.Y, a.X * b.Z, a.Y * b.X)))
        .Or(Crosses("y and z have the wrong sign", (_, _, n) => new(n.X, -n.Y, -n.Z)));

    public static Mistake OfZ => Of("cross-z", 2, "ax by − ay by", "the cross product's z is ax by − ay by",
        (a, b, n) => n with { Z = a.X * b.Y - a.Y * b.Y },
        "The picture is skewed, and triangles are torn.",
        "What is (1, 2, 0) × (3, 5, 0)?")
        .Or(Crosses("x and z are swapped", (_, _, n) => new(n.Z, n.Y, n.X)))
        .Or(Crosses("x and z have the wrong sign", (_, _, n) => new(-n.X, n.Y, -n.Z)));

    public static Mistake OfX => Of("cross-x", 0, "az by − ay bz", "the cross product's x has the wrong sign", (_, _, n) => n with { X = -n.X },
        "The picture is mirrored, turned or skewed, and triangles are torn.",
        "What is (0, 1, 0) × (0, 0, 1)?")
        .Or(Crosses("x and y are swapped", (_, _, n) => new(n.Y, n.X, n.Z)))
        .Or(Crosses("x and y have the wrong sign", (_, _, n) => new(-n.X, -n.Y, n.Z)))
        .Or(Crosses("components have moved on by one place", (_, _, n) => new(n.Y, n.Z, n.X)))
        .Or(Crosses("components have moved back by one place", (_, _, n) => new(n.Z, n.X, n.Y)));

    /// <summary>A mistake in one component, with that component's other variants.</summary>
    /// <param name="usual">The component as it is in the first variant.</param>
    private static Mistake Of(string id, int own, string usual, string cause, Func<Vector3, Vector3, Vector3, Vector3> other,
        string symptom, string question) =>
        new Mistake(id, Affects.Camera, Slides.Vectors, cause, Product(other) + ByCross[0].Deviate, symptom, question,
            "a × b = (ay bz − az by, az bx − ax bz, ax by − ay bx).").In(ByCross).Or(CrossVariants(own, usual));

    /// <summary>A component with other letters, with other signs, or with a term forgotten.</summary>
    private static IEnumerable<(string, Action<Lab>)> CrossVariants(int own, string usual)
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
               select Crosses($"{axes[own]} is {slip.Is}", (a, b, n) => WithOwn(slip.Of(a, b), n))[way];

        Vector3 WithOwn(double component, Vector3 n) => VectorMistakes.Parts[own].Of(new(component, component, component), n);
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
            ($"the cross product's {which}; the same, and {CameraWays.ByInverse.Cause}", forwards + CameraWays.ByInverse.Deviate),
            ($"the cross product's {which}; {CameraWays.ByInverse.Cause}", wrong + CameraWays.ByInverse.Deviate),
            ($"the cross product's {which}; V is up without its part along W, U = V × W", wrong + CameraWays.ProjectUp),
            ($"the cross product's {which}; the camera turned by two angles, from axes made with it", wrong + CameraWays.TurnByAngles),
            ($"the cross product's {which}; the camera turned by yaw and pitch, and rolled by an angle made with it", wrong + CameraWays.Roll),
            .. from style in ByCross.Take(4)
               select ($"the cross product's {which}, not in the camera; {style.Cause}", wrong + CameraWays.RightAxes + style.Deviate),
        ];
    }

    private static Action<Lab> Product(Func<Vector3, Vector3, Vector3, Vector3> other) =>
        lab => lab.Cross.Becomes(cross => (a, b) => other(a, b, cross(a, b)));

    /// <summary>Other right ways to write the formulas that use a cross product: in each a wrong one shows otherwise.</summary>
    private static (string Cause, Action<Lab> Deviate)[] ByCross =>
    [
        ("triangles compare areas along n", Triangles((lab, triangle, d) => lab.TriangleByShares(triangle, d, lab.Cross.Do))),
        ("triangles take only n from it", Triangles((lab, triangle, d) => lab.TriangleByShares(triangle, d, (a, b) => a % b))),
        ("circles count along two axes of their own", VectorMistakes.InCircleAxes(turned: false)),
        ("circles count along two axes of their own, n × x first", VectorMistakes.InCircleAxes(turned: true)),
        ("triangles compare volumes", Triangles((lab, triangle, d) => lab.TriangleByVolumes(triangle, d))),
        ("triangles compare volumes and take t from them", Triangles((lab, triangle, d) => lab.TriangleByVolumes(triangle, d, tFromCorners: true))),
        ("triangles compare determinants", Triangles((lab, triangle, d) => lab.TriangleByDeterminants(triangle, d))),
        ("triangles compare areas", VectorMistakes.ByAreas),
        ("triangles compare areas seen from X", Triangles((lab, triangle, d) => lab.TriangleByAreas(triangle, d, 1e-9, fromX: true))),
        ("triangles take n and (P − A) × d", Triangles((lab, triangle, d) => lab.TriangleByRay(triangle, d))),
        CameraWays.ByInverse,
        ("triangles compare sides", Triangles((lab, triangle, d) => lab.TriangleBySides(triangle, d, byNormal: false))),
        ("triangles compare sides with n", Triangles((lab, triangle, d) => lab.TriangleBySides(triangle, d, byNormal: true))),
        ("triangles take u = ((C − A) × n)·(X − A) / n·n", Triangles((lab, triangle, d) => lab.TriangleByCoordinates(triangle, d))),
        ("planes are crossed by Cramer's rule, with two axes of their own", PlanesByAxes),
        VectorMistakes.SphereByCross,
        ("triangles are asked in two of x, y and z", Triangles((lab, triangle, d) => lab.TriangleFlattened(triangle, d))),
    ];

    /// <summary>Planes are spanned by two axes, made with the cross product; Cramer's rule for where the ray crosses them needs none.</summary>
    private static void PlanesByAxes(Lab lab) => lab.Plane.Becomes(cross => (plane, d) =>
    {
        var n = plane.Normal;
        var a = lab.Cross.Do(n, Math.Abs(n.X) < Math.Abs(n.Y) ? new(1, 0, 0) : new(0, 1, 0));
        return cross(plane with { Normal = a % lab.Cross.Do(n, a) }, d);
    });

    private static Action<Lab> Triangles(Func<Lab, Triangle, Vector3, Crossings<Scalar>> cross) =>
        lab => lab.TriangleIs((triangle, d) => cross(lab, triangle, d));
}
