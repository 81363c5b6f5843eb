namespace RayCaster.Documents;

/// <summary>Which other mistakes look like one, in the scene that shows it.</summary>
/// <param name="Alike">They give the same picture.</param>
/// <param name="Near">They give nearly the same: they differ in a tenth of the pixels in which the mistake differs from the right picture.</param>
internal sealed record Resemblance(IReadOnlyList<Mistake> Alike, IReadOnlyList<Mistake> Near)
{
    /// <summary>Few are enough: only what looks alike all over is looked for.</summary>
    private const int Samples = 900;

    private const int Most = 4;

    /// <summary>Compares the whole catalogue, each mistake in its scene.</summary>
    public static Dictionary<Mistake, Resemblance> OfAll()
    {
        var all = MistakeCatalog.All;
        var samples = new Dictionary<(string Scene, Mistake? Mistake), byte[]>();
        var shows = all.ToDictionary(mistake => mistake, mistake => Showcase.Of(mistake).Name);
        var labs = shows.Values.Distinct().SelectMany(name => all.Append(null).Select(mistake => (name, mistake))).ToArray();
        var drawn = new byte[labs.Length][];
        Parallel.For(0, labs.Length, i => drawn[i] = Draw(labs[i].name, labs[i].mistake));
        for (var i = 0; i < labs.Length; i++) samples[labs[i]] = drawn[i];
        return all.ToDictionary(mistake => mistake, mistake =>
        {
            byte[] Of(Mistake? other) => samples[(shows[mistake], other)];
            var own = Difference(Of(mistake), Of(null));
            var others = all.Where(other => other != mistake && own > 0)
                .Select(other => (Mistake: other, Difference: Difference(Of(mistake), Of(other)))).OrderBy(other => other.Difference).ToArray();
            return new Resemblance(
                [.. others.Where(other => other.Difference == 0).Select(other => other.Mistake)],
                [.. others.Where(other => other.Difference > 0 && other.Difference <= 0.1 * own).Take(Most).Select(other => other.Mistake)]);
        });
    }

    /// <summary>The size of the file and some of its pixels.</summary>
    private static byte[] Draw(string name, Mistake? mistake)
    {
        var scene = Showcase.Whole.First(showcase => showcase.Name == name).Scene;
        var lab = mistake is null ? new Lab(scene) : new Lab(scene, mistake);
        var count = lab.Width * lab.Height;
        var bytes = new byte[1 + 3 * Samples];
        bytes[0] = (byte)lab.Width;
        for (var k = 0; k < Samples; k++)
        {
            var (y, x) = Math.DivRem((int)(k * (long)(0.618033988749895 * count) % count), lab.Width);
            (bytes[1 + 3 * k], bytes[2 + 3 * k], bytes[3 + 3 * k]) = lab[x, y];
        }
        return bytes;
    }

    /// <summary>In how many pixels samples differ by more than rounding; in all if their sizes do.</summary>
    private static int Difference(byte[] a, byte[] b)
    {
        if (a[0] != b[0]) return Samples;
        var count = 0;
        for (var i = 1; i < a.Length; i += 3)
            if (Math.Abs(a[i] - b[i]) > 2 || Math.Abs(a[i + 1] - b[i + 1]) > 2 || Math.Abs(a[i + 2] - b[i + 2]) > 2) count++;
        return count;
    }
}
