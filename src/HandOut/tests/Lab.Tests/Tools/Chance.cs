using System.Globalization;

namespace Lab.Tests;

/// <summary>Random numbers: other ones in each run, but the same again where the environment variable LAB_SEED says which.</summary>
public sealed class Chance
{
    private static readonly int seed = int.TryParse(Environment.GetEnvironmentVariable("LAB_SEED"), CultureInfo.InvariantCulture, out var given)
        ? given : Random.Shared.Next(1, 1_000_000);

    [ThreadStatic]
    private static bool isUsed; // by the test that runs on this thread

    private readonly Random random = new(seed);

    public Chance() => isUsed = false; // xunit makes one for each test

    /// <summary>How to have the same numbers again, as the last line of a message; empty in a test that uses none.</summary>
    public static string Again => isUsed ? $"\n  The same random numbers again: dotnet test -e LAB_SEED={seed}" : "";

    /// <summary>A number from −size to size.</summary>
    public double Number(double size = 10) => (2 * Next() - 1) * size;

    /// <summary>A number from 0.2 to size.</summary>
    public double Length(double size = 4) => 0.2 + Next() * (size - 0.2);

    /// <summary>A point in the cube from −size to size.</summary>
    public RayCaster.Vector3 Point(double size = 10) => new(Number(size), Number(size), Number(size));

    /// <summary>A direction of any length but near 0.</summary>
    public RayCaster.Vector3 Direction()
    {
        var v = Point(1);
        return v.Length > 0.2 ? v : Direction();
    }

    private double Next()
    {
        isUsed = true;
        return random.NextDouble();
    }
}
