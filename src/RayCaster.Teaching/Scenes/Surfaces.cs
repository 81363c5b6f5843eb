namespace RayCaster.Teaching;

/// <summary>The normals and surface parameters of the slides' shapes (docs/maps.md).</summary>
internal static class Surfaces
{
    /// <summary>A vector of any length perpendicular to a shape's surface, towards either side; null for other shapes.</summary>
    /// <param name="X">A point of the surface, up to rounding.</param>
    public static Vector3? Normal(Model shape, Vector3 X) => shape switch
    {
        Model<Plane> { Primitive.Normal: var n } => n,
        Model<Sphere> { Primitive.Center: var C } => X - C,
        Model<Aabb> { Primitive: var box } => FaceOf(box, X) switch { 0 => new(1, 0, 0), 1 => new(0, 1, 0), _ => new(0, 0, 1) },
        Model<Circle> { Primitive.Normal: var n } => n,
        Model<Triangle> { Primitive: var (A, B, C) } => (B - A).Normalized % (C - A).Normalized,
        _ => null,
    };

    /// <summary>Where on the surface a point lies; (0, 0) for other shapes.</summary>
    /// <inheritdoc cref="Normal"/>
    public static (double U, double V) Parameters(Model shape, Vector3 X) => shape switch
    {
        Model<Plane> { Primitive: var (Q, n) } => OfPlane(Q, n, X),
        Model<Sphere> { Primitive.Center: var C } => OfSphere((X - C).Normalized),
        Model<Aabb> { Primitive: var box } => OfBox(box, X),
        Model<Circle> { Primitive: var circle } => OfCircle(circle, X),
        Model<Triangle> { Primitive: var triangle } => OfTriangle(triangle, X),
        _ => default,
    };

    /// <summary>Distances from Q along two axes of the plane. u runs along z × n, which is horizontal, or along y × n where n is nearest to z;
    /// v runs along n × u. On a floor u and v run along x and y; on a wall v runs upwards.</summary>
    private static (double, double) OfPlane(Vector3 Q, Vector3 normal, Vector3 X)
    {
        var n = normal.Normalized;
        var isLevel = Math.Abs(n.Z) >= Math.Max(Math.Abs(n.X), Math.Abs(n.Y));
        var u = ((isLevel ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1)) % n).Normalized;
        return ((X - Q) * u, (X - Q) * (n % u));
    }

    /// <summary>Longitude and latitude: u runs from 0 to 1 once around the z axis, from −x over −y, x and y; v from 0 at the lower pole to 1 at
    /// the upper.</summary>
    private static (double, double) OfSphere(Vector3 n) =>
        (0.5 + Math.Atan2(n.Y, n.X) / (2 * Math.PI), 0.5 + Math.Asin(Math.Clamp(n.Z, -1, 1)) / Math.PI);

    /// <summary>On each face the other two coordinates, in the order x, y, z, each from 0 at B0 to 1 at B1.</summary>
    private static (double, double) OfBox(Aabb box, Vector3 X)
    {
        var (x, y, z) = (Part(X.X, box.Min.X, box.Max.X), Part(X.Y, box.Min.Y, box.Max.Y), Part(X.Z, box.Min.Z, box.Max.Z));
        return FaceOf(box, X) switch { 0 => (y, z), 1 => (x, z), _ => (x, y) };

        static double Part(double x, double lo, double hi) => hi > lo ? (x - lo) / (hi - lo) : 0;
    }

    /// <summary>Polar: u is the angle about C from the u axis of the disc's plane, 0 to 1; v is |X − C| / R.</summary>
    private static (double, double) OfCircle(Circle circle, Vector3 X)
    {
        var (x, y) = OfPlane(circle.Center, circle.Normal, X);
        var angle = Math.Atan2(y, x) / (2 * Math.PI);
        return (angle < 0 ? angle + 1 : angle, (X - circle.Center).Length / circle.Radius);
    }

    /// <summary>Barycentric: X = (1 − u − v) A + u B + v C.</summary>
    private static (double, double) OfTriangle(Triangle triangle, Vector3 X)
    {
        var (A, B, C) = triangle;
        var size = Math.Max((B - A).Length, (C - A).Length); // the unit: without it, n * n could overflow
        var (e1, e2, p) = ((B - A) / size, (C - A) / size, (X - A) / size);
        var n = e1 % e2;
        return (p % e2 * n / (n * n), e1 % p * n / (n * n));
    }

    /// <summary>The axis, 0 to 2, of the box's face nearest to a point.</summary>
    private static int FaceOf(Aabb box, Vector3 X)
    {
        double[] distances = [Distance(X.X, box.Min.X, box.Max.X), Distance(X.Y, box.Min.Y, box.Max.Y), Distance(X.Z, box.Min.Z, box.Max.Z)];
        return Array.IndexOf(distances, distances.Min());

        static double Distance(double x, double lo, double hi) => Math.Min(Math.Abs(x - lo), Math.Abs(x - hi));
    }
}
