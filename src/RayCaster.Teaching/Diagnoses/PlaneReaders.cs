using static RayCaster.Teaching.SlideFormulas;

namespace RayCaster.Teaching;

/// <summary>The shapes that may share the plane's formula t = (Q − P)·n / d·n, so that one slip shows in several of them.</summary>
internal static class PlaneReaders
{
    /// <summary>All shapes that lie in a plane.</summary>
    public const Affects All = Affects.Planes | Affects.Circles | Affects.Triangles;

    private static readonly (string Names, Affects Shapes)[] groups =
    [
        ("plane", Affects.Planes), ("plane and circle", Affects.Planes | Affects.Circles), ("plane, circle and triangle", All),
        ("circle", Affects.Circles), ("triangle", Affects.Triangles), ("circle and triangle", Affects.Circles | Affects.Triangles),
    ];

    /// <summary>Another t, from P, Q, n and d, for each group of shapes that may share the formula; planes alone come first.</summary>
    public static IEnumerable<(string Cause, Action<Lab> Deviate)> Of(string formula, Func<Vector3, Vector3, Vector3, Vector3, double> t)
    {
        foreach (var (names, shapes) in groups) yield return ($"{names}: {formula}", At(shapes, t));
    }

    /// <summary>Another t, from P, Q, n and d, for some shapes; circles and triangles ask for X = P + t d.</summary>
    public static Action<Lab> At(Affects shapes, Func<Vector3, Vector3, Vector3, Vector3, double> t) => lab =>
    {
        if (shapes.HasFlag(Affects.Planes)) lab.Plane.Is((plane, d) => new(t(lab.P, plane.Point, plane.Normal, d)));
        if (shapes.HasFlag(Affects.Circles))
        {
            lab.Circle.Is((circle, d) =>
            {
                var at = t(lab.P, circle.Center, circle.Normal, d);
                return (lab.P + at * d - circle.Center).Length <= circle.Radius ? new(at) : None;
            });
        }
        if (shapes.HasFlag(Affects.Triangles))
            lab.TriangleT.Is((A, n, d) => t(lab.P, A, n, d));
    };
}
