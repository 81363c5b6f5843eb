using System.Buffers.Binary;
using System.Globalization;

namespace RayCaster.Tests.Accuracy;

/// <summary>
/// Writes the rays that tests/RayCaster.Tests/Accuracy/exact.py judges: a file for each shape and regime, rows of little-endian doubles with our two
/// crossings at the end. tests/RayCaster.Tests/Accuracy/README.md has the command.
/// </summary>
public class RaysForExactArithmetic
{
    /// <summary>Without RAYCASTER_RAYS a few rays into a folder of the test's own.</summary>
    [Fact]
    public void EveryFileHasItsRows()
    {
        using var own = new TemporaryFolder();
        var folder = Environment.GetEnvironmentVariable("RAYCASTER_TO") ?? own.Path;
        var count = int.Parse(Environment.GetEnvironmentVariable("RAYCASTER_RAYS") ?? "20", CultureInfo.InvariantCulture);
        Directory.CreateDirectory(folder);
        var (seed, bytes) = (1, new byte[8]);
        foreach (var (shape, regime, make) in AccuracyRays.All())
        {
            var random = new Random(seed++);
            var path = Path.Combine(folder, $"{shape}-{regime}.rays");
            var numbers = 0;
            using (var file = File.Create(path))
                for (var i = 0; i < count; i++)
                {
                    var row = make(random);
                    var (near, far) = AccuracyRays.Cross(shape, row);
                    foreach (var number in row.Append(near).Append(far))
                    {
                        BinaryPrimitives.WriteDoubleLittleEndian(bytes, number);
                        file.Write(bytes);
                        numbers++;
                    }
                }
            var each = shape switch { "plane" or "aabb" => 14, "sphere" => 12, "circle" => 15, _ => 17 };
            Assert.Equal((count * each, 8L * count * each), (numbers, new FileInfo(path).Length));
        }
    }
}
