namespace RayCaster.Engine;

/// <summary>The range of a channel's level as a function of t, which is linear where neither the light nor the level is clamped.</summary>
internal readonly struct FloatLevel
{
    private readonly float slope, least, width;

    /// <param name="channel">The model's channel, 0 to 1.</param>
    /// <param name="fade">The camera's fade distance: the distance at which no light is left.</param>
    /// <param name="error">The greatest difference between t in floats and in doubles.</param>
    public FloatLevel(double channel, double fade, double error)
    {
        double atZero = Color.Level<Scalar>(channel), perT = SlopeOf(channel, fade);
        var slack = error * -perT + FloatBytes.RoundingOfALine;
        (slope, least, width) = ((float)perT, (float)(atZero - slack), (float)(2 * slack));
    }

    /// <summary>The level is certainly not less than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Least(Vector256<float> t) => Vector256.FusedMultiplyAdd(t, Vector256.Create(slope), Vector256.Create(least));

    /// <summary>The level is certainly not more than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Most(Vector256<float> least) => least + Vector256.Create(width);

    public static double SlopeOf(double channel, double fade) => ((double)Color.Level<Scalar>(0) - Color.Level<Scalar>(channel)) / fade;
}

/// <summary>The levels of a colour's channels.</summary>
internal readonly struct FloatLevels(Color color, double fade, double error)
{
    public readonly FloatLevel Red = new(color.R, fade, error), Green = new(color.G, fade, error), Blue = new(color.B, fade, error);
}
