using System.Numerics;

namespace RayCaster.Teaching.Comparison;

/// <summary>
/// An order of places in which any beginning is spread evenly over all of them: steps of the golden section, round and round. Each place comes
/// once.
/// </summary>
internal readonly struct GoldenRatioSequence
{
    private readonly int count;
    private readonly long step;

    /// <param name="count">How many places, at least 1.</param>
    public GoldenRatioSequence(int count)
    {
        this.count = count;
        step = Math.Max(1, (long)(count * 0.618033988749895));
        while (!BigInteger.GreatestCommonDivisor(step, count).IsOne) step++;
    }

    public int this[int k] => (int)(k * step % count);
}
