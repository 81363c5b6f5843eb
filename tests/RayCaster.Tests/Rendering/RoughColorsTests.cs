using System.Runtime.Intrinsics;

namespace RayCaster.Tests.Rendering;

/// <summary>The error bound of rough bytes counts on half a step for a colour that is looked up.</summary>
public class RoughColorsTests
{
    [Theory]
    [InlineData(15)]
    [InlineData(31)]
    [InlineData(32)]
    [InlineData(1000)]
    public unsafe void AreOffByHalfAStepAtMost(int models)
    {
        if (!RoughBytes.IsSupported) return; // nobody asks for them
        var random = new Random(models);
        var colors = new Color[models + 1];
        for (var i = 0; i < colors.Length; i++) colors[i] = new(1.5 * random.NextDouble(), random.NextDouble(), i % 7 == 0 ? 0 : 1.5);
        var all = new Model[models];
        for (var i = 0; i < models; i++) all[i] = new Model<Sphere>(new(Vector3.Zero, 1)) { Color = colors[i + 1] };
        var rough = new RoughColors(new Scene(new Camera(new(5, 0, 0), Vector3.Zero), all, colors[0]));

        var lanes = new int[16];
        for (var first = 0; first < colors.Length; first += 16)
        {
            for (var i = 0; i < lanes.Length; i++) lanes[i] = Math.Min(first + i, models);
            fixed (long* packed = rough.Packed)
            {
                var (r, g, b) = rough.At(packed, Vector512.Create(lanes));
                for (var i = 0; i < lanes.Length; i++)
                {
                    var color = colors[lanes[i]];
                    var off = Math.Max(Math.Abs(r[i] * rough.Step - color.R), Math.Max(Math.Abs(g[i] * rough.Step - color.G), Math.Abs(b[i] * rough.Step - color.B)));
                    Assert.InRange(off, 0, 0.500001 * rough.Step);
                }
            }
        }
    }
}
