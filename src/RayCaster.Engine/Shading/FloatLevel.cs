using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>The range of a channel's level as a function of t, which is linear where neither the light nor the level is clamped.</summary>
internal readonly struct FloatLevel
{
    private readonly Vector512<float> slope, least, most;

    /// <param name="channel">The model's channel, 0 to 1.</param>
    /// <param name="reach">The distance at which no light is left.</param>
    /// <param name="error">The greatest difference between t in floats and in doubles.</param>
    public FloatLevel(double channel, double reach, double error)
    {
        double atZero = Color.Level<Scalar>(channel), perT = SlopeOf(channel, reach);
        var slack = error * -perT + FloatBytes.RoundingOfALine;
        slope = Vector512.Create((float)perT);
        (least, most) = (Vector512.Create((float)(atZero - slack)), Vector512.Create((float)(atZero + slack)));
    }

    /// <summary>The change of the level for one unit of t.</summary>
    public static double SlopeOf(double channel, double reach) => ((double)Color.Level<Scalar>(0) - Color.Level<Scalar>(channel)) / reach;

    /// <summary>The level is certainly not less than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> Least(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, slope, least);

    /// <summary>The level is certainly not more than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> Most(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, slope, most);
}
