using System.Globalization;
using System.Text.RegularExpressions;

namespace RayCaster.Tests.Accuracy;

/// <summary>
/// The worst of millions of rays (worst.txt, computed exactly by exact.py) are no worse than README.md beside it says.
/// </summary>
public class AccuracyTests
{
    private sealed record Case(string Shape, string Regime, double[] Row, string Near, string Far)
    {
        public bool IsHit => Near != "none";

        public static Case Parse(string line)
        {
            var words = line.Split(' ');
            double[] row = [.. words[2..^2].Select(word => BitConverter.UInt64BitsToDouble(Convert.ToUInt64(word, 16)))];
            return new(words[0], words[1], row, words[^2], words[^1]);
        }
    }

    /// <summary>A line of the table in tests/RayCaster.Tests/Accuracy/README.md.</summary>
    private sealed record Stated(double Ulps, double FromOutline);

    private static readonly Case[] cases =
        [.. File.ReadLines(ProjectFolder.PathOf("tests/RayCaster.Tests/Accuracy/worst.txt")).Select(Case.Parse)];

    private static readonly Dictionary<(string Shape, string Regime), Stated> table = ReadTable();

    public static TheoryData<string, string> Kept
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (var (shape, regime, _) in AccuracyRays.All()) data.Add(shape, regime);
            return data;
        }
    }

    /// <summary>
    /// Where there are wrong decisions. Not flat shapes seen along their plane, 1e-13 of their length wide: a little sideways is beyond
    /// them.
    /// </summary>
    public static TheoryData<string, string> Outlines
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (var ((shape, regime), stated) in table)
                if (stated.FromOutline > 0 && (regime != "grazing" || shape == "sphere")) data.Add(shape, regime);
            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Kept))]
    public void NoParameterIsFartherFromTheExactOneThanTheTableSays(string shape, string regime)
    {
        var count = 0;
        foreach (var kept in Of(shape, regime))
        {
            var (near, far) = AccuracyRays.Cross(shape, kept.Row);
            if (!kept.IsHit || !double.IsFinite(near)) continue;
            count++;
            foreach (var (t, exact) in new[] { (near, kept.Near), (far, kept.Far) })
            {
                if (exact == "none") continue;
                var ulps = ExactDecimal.Ulps(t, exact);
                Assert.True(ulps <= Most(table[(shape, regime)].Ulps),
                    $"expected t = {exact}, but got t = {t:R}, {ulps:g3} units in the last place away.{AccuracyRays.Describe(shape, kept.Row)}");
            }
        }
        Assert.True(count >= 10);
    }

    /// <summary>A ray that is wrongly taken for a hit or a miss is so near the outline that a little sideways it is not.</summary>
    [Theory]
    [MemberData(nameof(Outlines))]
    public void AWrongDecisionIsAsNearTheOutlineAsTheTableSays(string shape, string regime)
    {
        foreach (var kept in Of(shape, regime))
        {
            if (double.IsFinite(AccuracyRays.Cross(shape, kept.Row).Near) == kept.IsHit) continue;
            var (middle, size) = MiddleAndSize(shape, kept.Row);
            var (P, d) = (At(kept.Row, 0), At(kept.Row, 3));
            var L = middle - P;
            var sideways = L - L * d * d; // to the middle
            // A hundred times as far as the table says, and as the camera's coordinates are rounded.
            var step = 100 * Math.Max(Most(table[(shape, regime)].FromOutline) * size, Math.ScaleB(L.Length, -53));
            var moved = P + (kept.IsHit ? Math.Min(step, 0.5 * sideways.Length) : -step) * sideways.Normalized;
            double[] row = [moved.X, moved.Y, moved.Z, .. kept.Row[3..]];
            Assert.True(double.IsFinite(AccuracyRays.Cross(shape, row).Near) == kept.IsHit,
                $"expected {(kept.IsHit ? "a crossing, but got none" : "no crossing, but got one")}.{AccuracyRays.Describe(shape, row)}");
        }
    }

    [Theory]
    [InlineData(1, "1.00000000000000000000000000000", 0)]
    [InlineData(1.0000000000000002, "1.0", 1)]
    [InlineData(0.9999999999999999, "1.0", 0.5)]
    [InlineData(-3e40, "-3.0e+40", 0.438464)] // Python's fractions say so
    [InlineData(1e-30, "1.0e-30", 0.475767)]
    [InlineData(0, "1.0", 4503599627370496)]
    public void ADoubleIsMeasuredInUnitsOfTheLastPlace(double t, string exact, double ulps) =>
        Assert.Equal(ulps, ExactDecimal.Ulps(t, exact), 1e-6);

    private static IEnumerable<Case> Of(string shape, string regime) =>
        cases.Where(kept => (kept.Shape, kept.Regime) == (shape, regime));

    /// <summary>What the table means by a number that it has rounded.</summary>
    private static double Most(double stated) => 1.006 * stated + 0.005 * (stated >= 0.01 ? 1 : 0);

    private static (Vector3 Middle, double Size) MiddleAndSize(string shape, double[] row) => shape switch
    {
        "sphere" => (At(row, 6), row[9]),
        "aabb" => (0.5 * (At(row, 6) + At(row, 9)), Largest(At(row, 9) - At(row, 6))),
        "circle" => (At(row, 6), row[12]),
        _ => ((At(row, 6) + At(row, 9) + At(row, 12)) / 3, LongestSide(At(row, 6), At(row, 9), At(row, 12))),
    };

    private static double LongestSide(Vector3 a, Vector3 b, Vector3 c) =>
        Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));

    private static double Largest(Vector3 v) => Math.Max(v.X, Math.Max(v.Y, v.Z));

    private static Vector3 At(double[] row, int i) => new(row[i], row[i + 1], row[i + 2]);

    private static Dictionary<(string, string), Stated> ReadTable()
    {
        var table = new Dictionary<(string, string), Stated>();
        foreach (var line in File.ReadLines(ProjectFolder.PathOf("tests/RayCaster.Tests/Accuracy/README.md")))
        {
            var cells = line.Split('|', StringSplitOptions.TrimEntries);
            if (cells.Length == 14 && Regex.IsMatch(cells[3], @"^[\d,]+$"))
                table.Add((cells[1], cells[2]), new(Number(cells[7]), Number(cells[11])));
        }
        return table;

        static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
    }
}
