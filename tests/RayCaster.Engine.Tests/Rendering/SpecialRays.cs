namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Seeded rays and shapes that look for trouble: zeros, axes, coordinates on faces, grazing, huge, tiny, and what makes NaN.</summary>
internal sealed class SpecialRays(int seed)
{
    private static readonly double[] Numbers =
        [0, -0.0, 1, -1, 0.5, 2, -5, 1e-300, -1e-300, 1e-30, 1e30, -1e40, double.Epsilon, 1 + 1e-15, 1 - 1e-16, 0.1, Math.PI];

    private readonly Random random = Some.Chance(seed);

    public double Number() => random.Next(4) switch
    {
        0 => Numbers[random.Next(Numbers.Length)],
        1 => random.Next(-3, 4),
        2 => (random.NextDouble() - 0.5) * 20,
        _ => (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-12, 13)),
    };

    public Vector3 Vector() => new(Number(), Number(), Number());

    public double Positive() => Math.Abs(Number()) is > 0 and var x ? x : 1;

    public Vector3 Direction()
    {
        var v = random.Next(3) == 0
            ? new Vector3(random.Next(-1, 2), random.Next(-1, 2), random.Next(-1, 2))
            : new Vector3(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
        return v.Normalized; // the zero vector gives NaN, which must go through a formula without harm
    }

    /// <summary>Towards a point, or past it by a few last bits.</summary>
    public Vector3 Towards(Vector3 origin, Vector3 point)
    {
        var d = (point - origin).Normalized;
        return random.Next(2) == 0 ? d : new(Math.BitIncrement(d.X), d.Y, Math.BitDecrement(d.Z));
    }

    public int Choose(int count) => random.Next(count);

    public Vector3 Mix(params Vector3[] points)
    {
        var sum = Vector3.Zero;
        var left = 1.0;
        foreach (var point in points)
        {
            var share = random.Next(3) == 0 ? 0 : left * random.NextDouble();
            sum += share * point;
            left -= share;
        }
        return sum + left * points[0];
    }
}
