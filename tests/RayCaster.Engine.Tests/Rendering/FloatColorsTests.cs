using System.Runtime.Intrinsics;

namespace RayCaster.Engine.Tests.Rendering;

/// <summary>The error bound of rough bytes counts on half a step for a colour that is looked up.</summary>
public class FloatColorsTests
{
    [Theory]
    [InlineData(15)]
    [InlineData(1000)]
    public void AreOffByHalfAStepAtMost(int models)
    {
        var random = new Random(models);
        var light = new double[3 * models + 3];
        for (var i = 0; i < light.Length; i += 3)
            (light[i], light[i + 1], light[i + 2]) = (1.5 * random.NextDouble(), random.NextDouble(), i % 7 == 0 ? 0 : 1.5);
        var rough = new FloatColors(light, light.Max());

        var lanes = new int[8];
        for (var first = 0; first <= models; first += 8)
        {
            for (var i = 0; i < lanes.Length; i++) lanes[i] = Math.Min(first + i, models);
            var (r, g, b) = FloatColors.At(rough.Packed, Vector256.Create(lanes));
            for (var i = 0; i < lanes.Length; i++)
            {
                var color = light.AsSpan(3 * lanes[i], 3);
                var off = Math.Max(Math.Abs(r.Lanes[i] * rough.Step - color[0]),
                    Math.Max(Math.Abs(g.Lanes[i] * rough.Step - color[1]), Math.Abs(b.Lanes[i] * rough.Step - color[2])));
                Assert.InRange(off, 0, 0.500001 * rough.Step);
            }
        }
    }
}
