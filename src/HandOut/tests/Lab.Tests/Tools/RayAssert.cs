using System.Diagnostics;
using System.Globalization;
using RayCaster;
using RayCaster.Teaching.Course;

namespace Lab.Tests;

/// <summary>Compares what the lab finds along a ray with what the library finds.</summary>
[StackTraceHidden] // the trace of a failure begins in the test
public static class RayAssert
{
    /// <summary>Casts a ray at a model of the lab and of the library. Rays on an outline, where the last bits decide, are left out.</summary>
    /// <param name="slide">The slide that has the formula.</param>
    /// <param name="model">The library's model; the lab's is made of it.</param>
    /// <param name="P">Where the ray starts.</param>
    /// <param name="aim">A point on the ray.</param>
    /// <param name="intersect">What to call in place of Intersect.</param>
    public static void Agrees(string slide, RayCaster.Model model, RayCaster.Vector3 P, RayCaster.Vector3 aim, Action<Model, Ray> intersect = null)
    {
        var d = (aim - P).Normalized;
        var expected = model.Intersect(new RayCaster.Ray(P, d));
        if (IsOnOutline(model, P, d, expected)) return;
        Hits(slide, model, P, d, expected, intersect);
        if (expected is not { } near) return;
        if (model.Intersect(new RayCaster.Ray(P, d) { ClipRange = new(near + 1e-3, 0, double.MaxValue) }) is not { } far) return;
        var between = (near + far) / 2; // where the near side is cut off, the far side shows; where the far side is, the near one still does
        Hits(slide, model, P, d, far, intersect, bias: between);
        Hits(slide, model, P, d, far, intersect, zNear: between / 2, depthPerT: 0.5);
        Hits(slide, model, P, d, near, intersect, zFar: between / 2, depthPerT: 0.5);
    }

    /// <summary>Numbers that are equal except in their last bits.</summary>
    public static void Equal(string what, string slide, double expected, double actual)
    {
        if (!AreEqual(expected, actual))
            Assert.Fail($"{what}: expected {Text(expected)}, but got {Text(actual)}{Precision((expected, actual))}.\n  {Cite(slide)}{Chance.Again}");
    }

    /// <summary>The same coordinate by coordinate.</summary>
    /// <param name="isUnit">Whether its length is to be 1.</param>
    public static void Equal(string what, string slide, RayCaster.Vector3 expected, Vector3 actual, bool isUnit = false)
    {
        if (AreEqual(expected, actual)) return;
        var got = new RayCaster.Vector3(actual.X, actual.Y, actual.Z);
        var length = isUnit && !AreEqual(1, got.Length) ? $", whose length is {Text(got.Length)}, not 1" : "";
        var precision = Precision((expected.X, got.X), (expected.Y, got.Y), (expected.Z, got.Z));
        Assert.Fail($"{what}: expected {Text(expected)}, but got {Text(got)}{precision}{length}.\n  {Cite(slide)}{Chance.Again}");
    }

    /// <summary>The lab's vector of a vector of the library.</summary>
    public static Vector3 Mine(RayCaster.Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>The slide that has the formula, as messages have it. The table of steps looks for what is not written.</summary>
    public static string Cite(string slide)
    {
        var step = Todo.Bodies.First(body => body.Slide == slide).Step;
        var missing = Todo.Missing(step);
        var isWritten = missing.All(body => body.Slide != slide);
        var isBegun = Todo.Bodies.Any(body => body.Step == step && !missing.Contains(body));
        return $"Slide \"{slide}\"{(isWritten ? "" : isBegun ? ", the part of the step that is not written yet" : ", which is not written yet")}";
    }

    /// <summary>A vector as messages have it.</summary>
    public static string Text(RayCaster.Vector3 v) => $"({Text(v.X)}, {Text(v.Y)}, {Text(v.Z)})";

    /// <summary>Casts one ray whose hit is known: t, or null for none.</summary>
    public static void Hits(
        string slide, RayCaster.Model model, RayCaster.Vector3 P, RayCaster.Vector3 d, double? expected, Action<Model, Ray> intersect = null,
        double bias = 0, double zNear = 0, double zFar = double.MaxValue, double depthPerT = 1)
    {
        var mine = SceneFile.PartsOf(model).Single();
        var ray = new WatchedRay(Mine(P), Mine(d)) { Bias = bias, ZNear = zNear, ZFar = zFar, DepthPerT = depthPerT };
        var untouched = new Untouched(("ray", ray), ("this", mine));
        if (intersect == null) mine.Intersect(ray);
        else intersect(mine, ray);
        untouched.Check(slide);
        if (ray.IsSetWithoutHit)
            Assert.Fail("HitParameter or HitModel was set without a call of Hit. Call ray.Hit(t, this): it keeps the nearest hit that counts." +
                $"\n  {Cite(slide)}");
        double? actual = ray.HitModel == null ? null : ray.HitParameter;
        if (expected is { } a && actual is { } b ? AreEqual(a, b) : expected == actual) return;
        var limits = depthPerT == 1 && bias == 0 && zNear == 0 ? "" // the ray is not clipped
            : $", Bias = {Text(bias)}, ZNear = {Text(zNear)}, ZFar = {(zFar == double.MaxValue ? "∞" : Text(zFar))}, DepthPerT = {Text(depthPerT)}";
        Assert.Fail($"""
            expected {Hit(expected)}, but got {Hit(actual)}{ray.Calls(actual)}{(expected is { } x && actual is { } y ? Precision((x, y)) : "")}.
              Ray    P = {Text(P)}, d = {Text(d)}{limits}
              {Letters(model)}
              Right  {BodyNumbers.Line(model, P, d, slide == "Sphere – Analytical Solution")}
              {Cite(ray.Miscounts(new(bias, zNear, zFar)) ? "zNear & zFar" : slide)}{Chance.Again}
            """);
    }

    /// <summary>A ray that remembers with which t its Hit was called.</summary>
    private sealed class WatchedRay(Vector3 origin, Vector3 direction) : Ray(origin, direction)
    {
        private readonly List<double> called = [];

        private (double, Model) kept = (double.PositiveInfinity, null); // by the last call

        public bool IsSetWithoutHit => kept != (HitParameter, HitModel);

        public override void Hit(double t, Model model)
        {
            called.Add(t);
            base.Hit(t, model);
            kept = (HitParameter, HitModel);
        }

        /// <summary>Whether Counts is wrong of a t with which Hit was called.</summary>
        public bool Miscounts(ClipRange range) => called.Exists(t => Counts(t) != (range.CountsMask<Scalar>(t, DepthPerT) != 0));

        public string Calls(double? hit) => hit != null ? ""
            : called.Count == 0 ? ": Hit was not called"
            : $": Hit was called with t = {string.Join(" and t = ", called.Select(Text))}, which {(called.Count == 1 ? "does" : "do")} not count";
    }

    private static string Hit(double? t) => t is { } number ? $"t = {Text(number)}" : "no hit";

    private static string Letters(RayCaster.Model model) => model switch
    {
        Model<RayCaster.Plane> { Primitive: var p } => $"Plane  Q = {Text(p.Point)}, n = {Text(p.Normal)}",
        Model<RayCaster.Sphere> { Primitive: var s } => $"Sphere C = {Text(s.Center)}, R = {Text(s.Radius)}",
        Model<RayCaster.Aabb> { Primitive: var b } => $"Aabb   B0 = {Text(b.Min)}, B1 = {Text(b.Max)}",
        Model<RayCaster.Circle> { Primitive: var c } => $"Circle C = {Text(c.Center)}, n = {Text(c.Normal)}, R = {Text(c.Radius)}",
        Model<RayCaster.Triangle> { Primitive: var t } => $"Triangle A = {Text(t.A)}, B = {Text(t.B)}, C = {Text(t.C)}",
        _ => model.Kind,
    };

    /// <summary>A number as messages have it.</summary>
    public static string Text(double number) =>
        number.ToString("0.######", CultureInfo.InvariantCulture) is var text && text == "-0" ? "0" : text;

    /// <summary>What to add where numbers differ only after so many digits as a float has.</summary>
    private static string Precision(params (double Expected, double Actual)[] numbers)
    {
        var apart = numbers.Max(pair => Math.Abs(pair.Expected - pair.Actual) / (1 + Math.Abs(pair.Expected)));
        return apart < 1e-5 ? $" (equal to {-Math.Ceiling(Math.Log10(apart)):0} digits: a float?)" : "";
    }

    /// <summary>Whether two numbers are equal except in their last bits.</summary>
    public static bool AreEqual(double a, double b) =>
        a.Equals(b) || a == b || (double.IsFinite(a - b) && Math.Abs(a - b) <= 1e-7 * (1 + Math.Min(Math.Abs(a), Math.Abs(b)))); // NaN equals NaN

    /// <summary>The same coordinate by coordinate.</summary>
    public static bool AreEqual(RayCaster.Vector3 a, Vector3 b) => AreEqual(a.X, b.X) && AreEqual(a.Y, b.Y) && AreEqual(a.Z, b.Z);

    /// <summary>Whether a ray a little beside this one hits where this one does not, or elsewhere.</summary>
    private static bool IsOnOutline(RayCaster.Model model, RayCaster.Vector3 P, RayCaster.Vector3 d, double? t)
    {
        foreach (var nudge in (double[])[-1e-6, 1e-6])
            foreach (var axis in (RayCaster.Vector3[])[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)])
            {
                var beside = model.Intersect(new RayCaster.Ray(P, (d + nudge * axis).Normalized));
                var moved = model.Intersect(new RayCaster.Ray(P + nudge * axis, d));
                if (beside == null != (t == null) || moved == null != (t == null)) return true;
                if (t is { } here && (Math.Abs(beside.Value - here) > 1e-2 || Math.Abs(moved.Value - here) > 1e-2)) return true;
            }
        return false;
    }
}
