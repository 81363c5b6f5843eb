using System.Globalization;
using Xunit.Abstractions;

namespace Lab.Tests;

/// <summary>Random numbers: other ones in each run, but the same again where the environment variable LAB_SEED says which.</summary>
public sealed class Chance
{
    private static readonly int seed = int.TryParse(Environment.GetEnvironmentVariable("LAB_SEED"), CultureInfo.InvariantCulture, out var given)
        ? given : Random.Shared.Next(1, 1_000_000);

    private readonly Random random = new(seed);

    /// <param name="output">Takes the seed, which the table of steps prints.</param>
    public Chance(ITestOutputHelper output) => output.WriteLine($"LAB_SEED={seed}");

    /// <summary>How to have the same numbers again.</summary>
    public static string Again => $"the same numbers again: set the environment variable LAB_SEED to {seed}";

    /// <summary>A number from −size to size.</summary>
    public double Number(double size = 10) => (2 * random.NextDouble() - 1) * size;

    /// <summary>A number from 0.2 to size.</summary>
    public double Length(double size = 4) => 0.2 + random.NextDouble() * (size - 0.2);

    /// <summary>A point in the cube from −size to size.</summary>
    public RayCaster.Vector3 Point(double size = 10) => new(Number(size), Number(size), Number(size));

    /// <summary>A direction of any length but near 0.</summary>
    public RayCaster.Vector3 Direction()
    {
        var v = Point(1);
        return v.Length > 0.2 ? v : Direction();
    }
}
