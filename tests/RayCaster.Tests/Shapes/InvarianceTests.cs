namespace RayCaster.Tests.Shapes;

/// <summary>What holds for every shape and every ray, over thousands of cases from fixed seeds.</summary>
public class InvarianceTests
{
    private const int Cases = 5000;

    /// <summary>What can be checked of any kind of shape, one random case at a time.</summary>
    private abstract class Kind
    {
        /// <summary>Coordinates on a grid move exactly, so t must stay the same to the last bit.</summary>
        public abstract void CheckMoved(Random random);

        /// <summary>A power of two changes no digit.</summary>
        public abstract void CheckScaled(Random random);

        /// <summary>Returns whether there was a hit to check.</summary>
        public abstract bool CheckOnSurface(Random random);
    }

    /// <summary>How to make a random shape, move it, scale it; and how far a point is off its surface.</summary>
    private sealed class Kind<P>(
        Func<Random, P> make, Func<P, Vector3, P> move, Func<P, double, P> scale, Func<P, Vector3, double> off) : Kind
        where P : struct, IPrimitive
    {
        public override void CheckMoved(Random random)
        {
            var (shape, origin, d) = (make(random), Some.GridPoint(random), Some.Direction(random));
            var by = 100 * Some.GridPoint(random);
            var (expected, got) = (Cast.Line(shape, origin, d), Cast.Line(move(shape, by), origin + by, d));
            if (!expected.Equals(got)) Assert.Fail($"moved by {by}, t = {expected} becomes {got}{RayAssert.Describe(shape, origin, d)}");
        }

        public override void CheckScaled(Random random)
        {
            var (shape, origin, d) = (make(random), Some.GridPoint(random), Some.Direction(random));
            var factor = Math.ScaleB(1, random.Next(-100, 134)); // scenes from 1e-30 to 1e40
            var (near, far) = Cast.Line(shape, origin, d);
            var (expected, got) = ((near * factor, far * factor), Cast.Line(scale(shape, factor), factor * origin, d));
            if (!expected.Equals(got)) Assert.Fail($"scaled by {factor}, t = {expected} becomes {got}{RayAssert.Describe(shape, origin, d)}");
        }

        public override bool CheckOnSurface(Random random)
        {
            var (shape, origin, d) = (make(random), Some.Point(random, 16), Some.Direction(random));
            if (Cast.At(shape, origin, d) is not { } t || t > 1000) return false; // far along a plane few digits are left
            var distance = off(shape, origin + t * d);
            if (!(distance < 1e-9)) Assert.Fail($"at t = {t} the ray is {distance} off the surface{RayAssert.Describe(shape, origin, d)}");
            return true;
        }
    }

    private static readonly Dictionary<string, Kind> kinds = new()
    {
        ["plane"] = new Kind<Plane>(
            random => new(Some.GridPoint(random), Some.Direction(random)),
            (plane, by) => plane with { Point = plane.Point + by },
            (plane, k) => plane with { Point = k * plane.Point },
            (plane, X) => Math.Abs((X - plane.Point) * plane.Normal)),
        ["sphere"] = new Kind<Sphere>(
            random => new(Some.GridPoint(random), 0.5 + 12 * random.NextDouble()),
            (sphere, by) => sphere with { Center = sphere.Center + by },
            (sphere, k) => new(k * sphere.Center, k * sphere.Radius),
            (sphere, X) => Math.Abs((X - sphere.Center).Length - sphere.Radius)),
        ["aabb"] = new Kind<Aabb>(
            random => Some.Box(Some.GridPoint(random), Some.GridPoint(random)),
            (box, by) => new(box.Min + by, box.Max + by),
            (box, k) => new(k * box.Min, k * box.Max),
            (box, X) => Math.Abs(Outside(box, X))),
        ["circle"] = new Kind<Circle>(
            random => new(Some.GridPoint(random), Some.Direction(random), 4 + 12 * random.NextDouble()),
            (circle, by) => circle with { Center = circle.Center + by },
            (circle, k) => circle with { Center = k * circle.Center, Radius = k * circle.Radius },
            (circle, X) => Math.Abs((X - circle.Center) * circle.Normal) + Math.Max(0, (X - circle.Center).Length - circle.Radius)),
        ["triangle"] = new Kind<Triangle>(
            random => new(Some.GridPoint(random), Some.GridPoint(random), Some.GridPoint(random)),
            (triangle, by) => new(triangle.A + by, triangle.B + by, triangle.C + by),
            (triangle, k) => new(k * triangle.A, k * triangle.B, k * triangle.C),
            Off),
    };

    public static TheoryData<string> Shapes => [.. kinds.Keys];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void MovingEverythingChangesNoBitOfT(string shape) => Repeat(shape, 6, (kind, random) => kind.CheckMoved(random));

    [Theory]
    [MemberData(nameof(Shapes))]
    public void ScalingEverythingByAPowerOfTwoScalesTExactly(string shape) => Repeat(shape, 7, (kind, random) => kind.CheckScaled(random));

    [Theory]
    [MemberData(nameof(Shapes))]
    public void TheHitIsOnTheSurface(string shape)
    {
        var hits = 0;
        Repeat(shape, 8, (kind, random) => hits += kind.CheckOnSurface(random) ? 1 : 0);
        Assert.True(hits > 100, $"only {hits} rays hit");
    }

    private static void Repeat(string shape, int seed, Action<Kind, Random> check)
    {
        var random = new Random(seed);
        for (var i = 0; i < Cases; i++) check(kinds[shape], random);
    }

    /// <summary>How far a point is outside the nearest face; negative inside.</summary>
    private static double Outside(Aabb box, Vector3 X)
    {
        var (a, b) = (box.Min - X, X - box.Max);
        return new[] { a.X, a.Y, a.Z, b.X, b.Y, b.Z }.Max();
    }

    /// <summary>How far a point is off the plane, and how much more area than the triangle the three have that it makes with the sides.</summary>
    private static double Off(Triangle triangle, Vector3 X)
    {
        var (a, b, c) = (triangle.A - X, triangle.B - X, triangle.C - X);
        var n = (triangle.B - triangle.A) % (triangle.C - triangle.A);
        return Math.Abs(a * n.Normalized) + Math.Abs((a % b).Length + (b % c).Length + (c % a).Length - n.Length) / n.Length;
    }
}
