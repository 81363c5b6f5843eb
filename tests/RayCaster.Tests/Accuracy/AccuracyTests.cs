using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using RayCaster.Tests.Shapes;

namespace RayCaster.Tests.Accuracy;

/// <summary>
/// The worst of millions of rays (worst.txt, computed exactly by exact.py) are no worse than table.txt beside it says.
/// </summary>
public class AccuracyTests
{
    /// <summary>A ray and its shape are a row of doubles: P, d, then what the scene file says of the shape.</summary>
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

    /// <summary>A line of table.txt.</summary>
    /// <param name="Wrong">How many rays are wrongly taken for hits or misses.</param>
    private sealed record Stated(double Ulps, int Wrong, double FromOutline);

    private static readonly Case[] cases =
        [.. File.ReadLines(ProjectFolder.PathOf("tests/RayCaster.Tests/Accuracy/worst.txt")).Select(Case.Parse)];

    private static readonly Dictionary<(string Shape, string Regime), Stated> table = ReadTable();

    public static TheoryData<string, string> Kinds
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (var (shape, regime) in table.Keys) data.Add(shape, regime);
            return data;
        }
    }

    [Fact]
    public void EachKindOfRayIsInTheTable() =>
        Assert.Equal(cases.Select(kept => (kept.Shape, kept.Regime)).ToHashSet(), [.. table.Keys]);

    [Theory]
    [MemberData(nameof(Kinds))]
    public void NoParameterIsFartherFromTheExactOneThanTheTableSays(string shape, string regime)
    {
        var count = 0;
        foreach (var kept in Of(shape, regime))
        {
            var (near, far) = Cross(shape, kept.Row);
            if (!kept.IsHit || !double.IsFinite(near)) continue;
            count++;
            foreach (var (t, exact) in new[] { (near, kept.Near), (far, kept.Far) })
            {
                if (exact == "none") continue;
                var ulps = ExactDecimal.Ulps(t, exact);
                Assert.True(ulps <= Most(table[(shape, regime)].Ulps),
                    $"expected t = {exact}, but got t = {t:R}, {ulps:g3} units in the last place away.{Describe(shape, kept.Row)}");
            }
        }
        Assert.InRange(count, 10, 16);
    }

    /// <summary>The four wrong decisions that are kept of each kind, or fewer if there were fewer, are still wrong, and a ray beside each is
    /// decided rightly: at twice the distance that the table says.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void AWrongDecisionIsAsNearTheOutlineAsTheTableSays(string shape, string regime)
    {
        var stated = table[(shape, regime)];
        var wrong = Of(shape, regime).Where(kept => IsHit(shape, kept.Row) != kept.IsHit).ToArray();
        Assert.Equal(Math.Min(4, stated.Wrong), wrong.Length);
        foreach (var kept in wrong)
        {
            var (P, d) = (At(kept.Row, 0), At(kept.Row, 3));
            var (right, distance) = ((d % new Vector3(d.Y, d.Z, d.X)).Normalized, (At(kept.Row, 6) - P).Length);
            var step = 2 * Most(stated.FromOutline) * SizeOf(shape, kept.Row) + 4 * Math.ScaleB(P.Length + distance, -53);
            Assert.True(Enumerable.Range(0, 16).Any(i => IsRight(i * Math.PI / 8)), $"expected {(kept.IsHit ? "a crossing" : "no crossing")}, "
                + $"or one {step} beside it.{Describe(shape, kept.Row)}");

            bool IsRight(double angle)
            {
                var moved = P + step * (Math.Cos(angle) * right + Math.Sin(angle) * (d % right));
                return IsHit(shape, [moved.X, moved.Y, moved.Z, .. kept.Row[3..]]) == kept.IsHit;
            }
        }
    }

    /// <summary>Not a test: writes our two crossings with each of the rays that rays.py has made, for exact.py to judge.</summary>
    [Fact(Explicit = true)]
    public void OurCrossingsAreWritten()
    {
        foreach (var path in Directory.GetFiles(Environment.GetEnvironmentVariable("RAYCASTER_RAYS")!, "*.rays"))
        {
            var shape = Path.GetFileName(path).Split('-')[0];
            var numbers = MemoryMarshal.Cast<byte, double>(File.ReadAllBytes(path)).ToArray();
            var crossings = numbers.Chunk(LengthOf(shape)).Select(row => Cross(shape, row)).SelectMany(t => new[] { t.Near, t.Far }).ToArray();
            File.WriteAllBytes(Path.ChangeExtension(path, ".crossings"), MemoryMarshal.AsBytes<double>(crossings));
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

    private static bool IsHit(string shape, double[] row) => double.IsFinite(Cross(shape, row).Near);

    /// <summary>What our formula says of a row.</summary>
    private static (double Near, double Far) Cross(string shape, double[] row)
    {
        var crossings = ShapeOf(shape, row).Intersect(new Ray<Scalar>(At(row, 0), At(row, 3)));
        return (crossings.Near, crossings.Far);
    }

    private static string Describe(string shape, double[] row) => RayAssert.Describe(ShapeOf(shape, row), At(row, 0), At(row, 3));

    private static IPrimitive ShapeOf(string shape, double[] row) => shape switch
    {
        "plane" => new Plane(At(row, 6), At(row, 9)),
        "sphere" => new Sphere(At(row, 6), row[9]),
        "aabb" => new Aabb(At(row, 6), At(row, 9)),
        "circle" => new Circle(At(row, 6), At(row, 9), row[12]),
        _ => new Triangle(At(row, 6), At(row, 9), At(row, 12)),
    };

    /// <summary>How many numbers a row has.</summary>
    private static int LengthOf(string shape) => shape switch { "plane" or "aabb" => 12, "sphere" => 10, "circle" => 13, _ => 15 };

    private static double SizeOf(string shape, double[] row) => shape switch
    {
        "sphere" => row[9],
        "aabb" => Largest(At(row, 9) - At(row, 6)),
        "circle" => row[12],
        _ => LongestSide(At(row, 6), At(row, 9), At(row, 12)),
    };

    private static double LongestSide(Vector3 a, Vector3 b, Vector3 c) =>
        Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));

    private static double Largest(Vector3 v) => Math.Max(v.X, Math.Max(v.Y, v.Z));

    private static Vector3 At(double[] row, int i) => new(row[i], row[i + 1], row[i + 2]);

    private static Dictionary<(string, string), Stated> ReadTable()
    {
        var table = new Dictionary<(string, string), Stated>();
        foreach (var line in File.ReadLines(ProjectFolder.PathOf("tests/RayCaster.Tests/Accuracy/table.txt")))
        {
            var cells = line.Split('|', StringSplitOptions.TrimEntries);
            if (cells.Length == 14 && Regex.IsMatch(cells[3], @"^[\d,]+$"))
                table.Add((cells[1], cells[2]), new(Number(cells[7]), (int)(Number(cells[9]) + Number(cells[10])), Number(cells[11])));
        }
        return table;

        static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
    }
}
