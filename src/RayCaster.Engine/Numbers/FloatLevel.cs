namespace RayCaster.Engine;

/// <summary>The range of a channel's level as a function of t, which is linear where neither the light nor the level is clamped.</summary>
internal readonly partial struct FloatLevel
{
    private readonly float slope, least, width;

    /// <param name="channel">The model's channel, 0 to 1.</param>
    /// <param name="reach">The distance at which no light is left.</param>
    /// <param name="error">The greatest difference between t in floats and in doubles.</param>
    public FloatLevel(double channel, double reach, double error)
    {
        double atZero = Color.Level<Scalar>(channel), perT = SlopeOf(channel, reach);
        var slack = error * -perT + FloatBytes.RoundingOfALine;
        (slope, least, width) = ((float)perT, (float)(atZero - slack), (float)(2 * slack));
    }

    /// <summary>The change of the level for one unit of t.</summary>
    public static double SlopeOf(double channel, double reach) => ((double)Color.Level<Scalar>(0) - Color.Level<Scalar>(channel)) / reach;
}

/// <summary>The levels of a colour's channels.</summary>
internal readonly struct FloatLevels(Color color, double reach, double error)
{
    public readonly FloatLevel Red = new(color.R, reach, error), Green = new(color.G, reach, error), Blue = new(color.B, reach, error);
}
