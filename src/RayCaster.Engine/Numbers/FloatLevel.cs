namespace RayCaster.Engine;

/// <summary>The range of a channel's level as a function of t, which is linear where neither the light nor the level is clamped.</summary>
internal readonly struct FloatLevel
{
    private readonly float slope, least, most;

    /// <param name="channel">The model's channel, 0 to 1.</param>
    /// <param name="reach">The distance at which no light is left.</param>
    /// <param name="error">The greatest difference between t in floats and in doubles.</param>
    public FloatLevel(double channel, double reach, double error)
    {
        double atZero = Color.Level<Scalar>(channel), perT = SlopeOf(channel, reach);
        var slack = error * -perT + FloatBytes.RoundingOfALine;
        (slope, least, most) = ((float)perT, (float)(atZero - slack), (float)(atZero + slack));
    }

    /// <summary>The change of the level for one unit of t.</summary>
    public static double SlopeOf(double channel, double reach) => ((double)Color.Level<Scalar>(0) - Color.Level<Scalar>(channel)) / reach;

    /// <summary>The level is certainly not less than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> Least(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, Vector512.Create(slope), Vector512.Create(least));

    /// <summary>The level is certainly not more than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> Most(Vector512<float> t) => Vector512.FusedMultiplyAdd(t, Vector512.Create(slope), Vector512.Create(most));

    /// <inheritdoc cref="Least(Vector512{float})"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Least(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(least));

    /// <inheritdoc cref="Most(Vector512{float})"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Most(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(most));
}

/// <summary>The levels of a colour's channels.</summary>
internal readonly struct FloatLevels(Color color, double reach, double error)
{
    public readonly FloatLevel Red = new(color.R, reach, error), Green = new(color.G, reach, error), Blue = new(color.B, reach, error);
}
