namespace RayCaster.Tests.Accuracy;

/// <summary>A shape about 1 large near the origin, and places to aim at.</summary>
/// <param name="Points">The shape's points: Q, C, B0 and B1, or the corners.</param>
/// <param name="Normal">n, of a plane or circle.</param>
/// <param name="Radius">R, of a sphere or circle.</param>
/// <param name="Aim">A point in or near the shape; most rays through it hit.</param>
/// <param name="Outline">A point on an edge or corner; a sphere has none.</param>
/// <param name="From">An ordinary place for a camera.</param>
/// <param name="Surface">A point of the surface.</param>
/// <param name="Across">The direction across the surface there.</param>
/// <param name="Inside">A point in the body.</param>
internal sealed record Target(
    Vector3[] Points, Vector3? Normal, double? Radius, Vector3 Aim, Vector3 Outline, Vector3 From, Vector3 Surface, Vector3 Across,
    Vector3 Inside = default)
{
    public static Target Plane(Random random)
    {
        var (Q, n) = (Some.Point(random, 1), Some.Direction(random));
        var X = Q + 3 * InPlane(random, n);
        return new([Q], (0.5 + random.NextDouble()) * n, null, X, X, Some.Point(random, 10), X, n);
    }

    public static Target Sphere(Random random)
    {
        var (C, R, across) = (Some.Point(random, 1), 0.2 + random.NextDouble(), Some.Direction(random));
        var (aim, inside) = (C + 1.2 * R * Some.Point(random, 1), C + 0.5 * R * Some.Point(random, 1));
        return new([C], null, R, aim, default, Some.Point(random, 10), C + R * across, across, inside);
    }

    /// <summary>A point on an edge, on a corner, or on the outline as seen from a place.</summary>
    public Vector3 OutlineFrom(Vector3 P, Random random)
    {
        if (Radius is not { } R || Normal is not null) return Outline;
        // A sphere's outline is a circle that lies a little before C.
        var L = Points[0] - P;
        var sine = Math.Min(1, R / L.Length);
        return Points[0] - sine * R * L.Normalized + Math.Sqrt(1 - sine * sine) * R * InPlane(random, L.Normalized);
    }

    public static Target Aabb(Random random) => Aabb(random, isFlat: false);

    public static Target FlatAabb(Random random) => Aabb(random, isFlat: true);

    private static Target Aabb(Random random, bool isFlat)
    {
        var (a, b) = (Numbers(Some.Point(random, 1)), Numbers(Some.Point(random, 1)));
        if (isFlat)
        {
            var thin = random.Next(3);
            b[thin] = a[thin];
        }
        double[] min = [.. a.Zip(b, Math.Min)], max = [.. a.Zip(b, Math.Max)];
        double[] Between(double beyond) =>
            [.. min.Zip(max, (lo, hi) => lo + (hi - lo) * (0.5 + (0.5 + beyond) * Some.Number(random, 1)))];
        double[] inside = Between(0), face = [.. inside], edge = [.. inside], across = new double[3];
        var axis = random.Next(3);
        var isMax = random.Next(2) == 1;
        face[axis] = (isMax ? max : min)[axis];
        across[axis] = isMax ? 1 : -1;
        var free = random.Next(4); // the axis that the edge follows; none for a corner
        for (var i = 0; i < 3; i++)
            if (i != free)
                edge[i] = (random.Next(2) == 1 ? max : min)[i];
        var aim = Vector(Between(0.2));
        Vector3[] corners = [Vector(min), Vector(max)];
        return new(corners, null, null, aim, Vector(edge), Some.Point(random, 10), Vector(face), Vector(across), Vector(inside));
    }

    public static Target Circle(Random random)
    {
        var (C, n, R) = (Some.Point(random, 1), Some.Direction(random), 0.2 + random.NextDouble());
        Vector3 At(double part) => C + part * R * InPlane(random, n);
        var (aim, surface) = (At(1.2 * random.NextDouble()), At(random.NextDouble()));
        return new([C], (0.5 + random.NextDouble()) * n, R, aim, At(1), Some.Point(random, 10), surface, n);
    }

    public static Target Triangle(Random random) =>
        Triangle(random, Some.Point(random, 1), Some.Point(random, 1), Some.Point(random, 1));

    /// <summary>A triangle whose height is 1e-3 to 1e-11 of its base; one of less than 1e-12 is a line.</summary>
    public static Target Sliver(Random random)
    {
        var (a, b) = (Some.Point(random, 1), Some.Point(random, 1));
        var height = (b - a).Length * AccuracyRays.Power(random, -11, -3);
        var c = a + random.NextDouble() * (b - a) + height * InPlane(random, (b - a).Normalized);
        return Triangle(random, a, b, c);
    }

    private static Target Triangle(Random random, Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 Weighted(double u, double v) => a + u * (b - a) + v * (c - a);
        var (u, v, onEdge) = (random.NextDouble(), random.NextDouble(), random.NextDouble());
        var inside = u + v < 1 ? Weighted(u, v) : Weighted(1 - u, 1 - v);
        var outline = random.Next(4) switch { 0 => a, 1 => a + onEdge * (b - a), 2 => b + onEdge * (c - b), _ => c + onEdge * (a - c) };
        var (aim, across) = (Weighted(1.2 * u - 0.1, 1.2 * v - 0.1), ((b - a) % (c - a)).Normalized);
        return new([a, b, c], null, null, aim, outline, Some.Point(random, 10), inside, across);
    }

    /// <summary>A direction across n.</summary>
    public static Vector3 InPlane(Random random, Vector3 n) => (Some.Direction(random) % n).Normalized;

    private static double[] Numbers(Vector3 v) => [v.X, v.Y, v.Z];

    private static Vector3 Vector(double[] v) => new(v[0], v[1], v[2]);
}
