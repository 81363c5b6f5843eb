using RayCaster.Tests.Shapes;

namespace RayCaster.Tests.Accuracy;

/// <summary>
/// Rays for README.md beside it, ordinary and extreme. A ray and its shape are a row of doubles: P, d, then what the scene file says of the
/// shape (plane Q n, sphere C R, aabb B0 B1, circle C n R, triangle a b c).
/// </summary>
internal static class AccuracyRays
{
    private static readonly Dictionary<string, Func<Random, Target>> targets = new()
    {
        ["plane"] = Target.Plane,
        ["sphere"] = Target.Sphere,
        ["aabb"] = Target.Aabb,
        ["circle"] = Target.Circle,
        ["triangle"] = Target.Triangle,
    };

    private static readonly Dictionary<string, Func<Random, Target, double[]>> regimes = new()
    {
        ["ordinary"] = (_, target) => Row(target, target.From, target.Aim - target.From),
        ["far"] = (random, target) =>
        {
            var P = Power(random, 2, 8) * Some.Direction(random);
            return Row(target, P, target.Aim - P);
        },
        ["extreme"] = (random, target) =>
        {
            var P = Power(random, 2, 8) * Some.Direction(random);
            return Row(target, P, target.Aim - P, Power(random, -30, 32), Power(random, -200, 200));
        },
        ["outline"] = (random, target) => Row(target, target.From, target.OutlineFrom(target.From, random) - target.From),
        ["distant"] = (random, target) =>
        {
            var P = Power(random, 2, 8) * Some.Direction(random);
            return Row(target, P, target.OutlineFrom(P, random) - P);
        },
        ["grazing"] = (random, target) =>
        {
            var back = (1 + 9 * random.NextDouble()) * Target.InPlane(random, target.Across) + Power(random, -12, -1) * target.Across;
            return Row(target, target.Surface + back, -back);
        },
        ["scaled"] = (random, target) =>
            Row(target, target.From, target.Aim - target.From, Power(random, -30, 40), Power(random, -200, 200)),
        ["moved"] = (random, target) =>
            Row(target, target.From, target.Aim - target.From, by: Power(random, 2, 8) * Some.Direction(random)),
        ["close"] = (random, target) => Row(target, target.Surface + Power(random, -8, -1) * target.Across, Some.Direction(random)),
        ["on"] = (random, target) => Row(target, target.Surface, Some.Direction(random)),
    };

    /// <summary>Every shape and every way to look at it.</summary>
    public static IEnumerable<(string Shape, string Regime, Func<Random, double[]> Make)> All()
    {
        foreach (var (shape, target) in targets)
        {
            foreach (var (regime, make) in regimes)
                if (shape != "plane" || regime is not ("outline" or "distant"))
                    yield return (shape, regime, random => make(random, target(random)));
            if (shape is "sphere" or "aabb")
                yield return (shape, "inside", random => target(random) is var some ? Row(some, some.Inside, Some.Direction(random)) : []);
        }
        yield return ("plane", "remote", RemotePlane);
        yield return ("aabb", "parallel", AlongABox);
        yield return ("aabb", "flat", random => regimes["ordinary"](random, Target.FlatAabb(random)));
        yield return ("triangle", "sliver", random => regimes["ordinary"](random, Target.Sliver(random)));
    }

    private static double[] RemotePlane(Random random)
    {
        var plane = Target.Plane(random);
        plane.Points[0] += Power(random, 2, 8) * Target.InPlane(random, plane.Across);
        return Row(plane, plane.From, plane.Aim - plane.From);
    }

    /// <summary>Along one or two of the slabs, and often exactly in a face.</summary>
    private static double[] AlongABox(Random random)
    {
        var (a, b, P, d) = (Some.GridPoint(random), Some.GridPoint(random), Some.GridPoint(random), Some.Direction(random));
        d = random.Next(4) switch { 0 => d with { X = 0 }, 1 => d with { Y = 0 }, 2 => d with { Z = 0 }, _ => new(0, 0, d.Z) };
        P = random.Next(3) switch { 0 => P with { X = a.X }, 1 => P with { Y = b.Y }, _ => P with { Z = a.Z } };
        Vector3 min = new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));
        Vector3 max = new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));
        return Row(new([min, max], null, null, default, default, P, default, default), P, d);
    }

    /// <summary>What our formula says of a row.</summary>
    public static (double Near, double Far) Cross(string shape, double[] row)
    {
        var crossings = ShapeOf(shape, row).Intersect(new Ray<Scalar>(At(row, 0), At(row, 3)));
        return (crossings.Near, crossings.Far);
    }

    /// <summary>Lines for the end of a message.</summary>
    public static string Describe(string shape, double[] row) => RayAssert.Describe(ShapeOf(shape, row), At(row, 0), At(row, 3));

    private static IPrimitive ShapeOf(string shape, double[] row) => shape switch
    {
        "plane" => new Plane(At(row, 6), At(row, 9)),
        "sphere" => new Sphere(At(row, 6), row[9]),
        "aabb" => new Aabb(At(row, 6), At(row, 9)),
        "circle" => new Circle(At(row, 6), At(row, 9), row[12]),
        "triangle" => new Triangle(At(row, 6), At(row, 9), At(row, 12)),
        _ => throw new ArgumentException(shape),
    };

    private static Vector3 At(double[] row, int i) => new(row[i], row[i + 1], row[i + 2]);

    /// <summary>10 to a power between two.</summary>
    public static double Power(Random random, double least, double most) => Math.Pow(10, least + (most - least) * random.NextDouble());

    private static double[] Row(Target target, Vector3 P, Vector3 towards, double scale = 1, double ofNormal = 1, Vector3 by = default)
    {
        var row = new List<double>();
        void Add(Vector3 v) => row.AddRange([v.X, v.Y, v.Z]);
        Add(scale * P + by);
        Add(towards.Normalized);
        foreach (var point in target.Points) Add(scale * point + by);
        if (target.Normal is { } n) Add(ofNormal * n);
        if (target.Radius is { } R) row.Add(scale * R);
        return [.. row];
    }
}
