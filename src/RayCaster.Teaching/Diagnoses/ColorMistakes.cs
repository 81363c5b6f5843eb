namespace RayCaster.Teaching;

/// <summary>Between a hit and three bytes.</summary>
internal static class ColorMistakes
{
    public static Mistake[] All =>
    [
        new("att-depth", Affects.Color, Slides.Shading, "attenuation by the depth t · (−d·W), not by t",
            lab => lab.Distance.Is((t, d) => lab.Depth.Do(t, d)),
            "The borders of the picture are too bright; all places are right.",
            "From where does the attenuation measure: from the camera, or from a plane through it?",
            "1 − t / (2 |T − P|), with t itself."),
        new("att-no2", Affects.Color, Slides.Shading, "1 − t / |T − P|: the 2 is missing",
            lab => lab.Attenuation.Becomes(fade => t => fade(2 * t)),
            "The picture is too dark, and black from the target on.",
            "How bright should the target be?",
            "1 − t / (2 |T − P|): the target has half of its light."),
        new("att-inv", Affects.Color, Slides.Shading, "t / (2 |T − P|): far is bright",
            lab => lab.Attenuation.Becomes(fade => t => 1 - fade(t)),
            "Far things are brighter than near ones.",
            "How bright should a thing at t = 0 be?",
            "1 − t / (2 |T − P|)."),
        new("att-none", Affects.Color, Slides.Shading, "no attenuation: the model's colour as it is",
            lab => lab.Attenuation.Is(_ => 1),
            "Everything is flat: each model has one colour.",
            "What makes a farther hit darker?",
            "colour = (1 − t / (2 |T − P|)) · the model's colour."),
        new("att-origin", Affects.Color, Slides.Shading, "attenuation by the hit's distance from the origin of the world",
            lab => lab.Distance.Is((t, d) => lab.Length.Do(lab.P + t * d)),
            "What is close to the point (0, 0, 0) is bright, wherever the camera is.",
            "|X| is the distance of X from which point?",
            "1 − t / (2 |T − P|): t is the distance from the camera."),
        new("att-int", Affects.Color, Slides.Shading, "the attenuation cut to an integer: 0",
            lab => lab.Attenuation.Becomes(fade => t => Math.Truncate(fade(t))),
            "Every model is black.",
            "Of which type is your attenuation, and what is (int)0.7?",
            "Compute in double up to the byte, and only then cast."),
        new("att-square", Affects.Color, Slides.Shading, "attenuation by the square: 1 − t² / (2 |T − P|)²",
            Fade((t, D, _) => 1 - t * t / (4 * D * D)),
            "Near things are too bright or all too dark: the light falls in another curve.",
            "At half of the way to 2 |T − P|, how much light is left?",
            "1 − t / (2 |T − P|), without a square."),
        new("att-inverse", Affects.Color, Slides.Shading, "attenuation 1 / t",
            Fade((t, _, _) => 1 / t),
            "The light never ends, and falls in another curve: everything is nearly black, or what is close has full light.",
            "At which t is all light gone on the slide?",
            "1 − t / (2 |T − P|): a straight line from 1 to 0."),
        new("att-inverse-square", Affects.Color, Slides.Shading, "attenuation 1 / t²",
            Fade((t, _, _) => 1 / (t * t)),
            "Everything is black, or what is close has full light and the rest hardly any.",
            "At which t is all light gone on the slide?",
            "1 − t / (2 |T − P|): a straight line from 1 to 0."),
        new("att-zfar", Affects.Color, Slides.Shading, "1 − t / zFar: zFar where 2 |T − P| is meant",
            Fade((t, _, camera) => 1 - t / camera.ZFar),
            "The light ends at zFar, not at twice the target's distance.",
            "How bright should the target be, wherever zFar is?",
            "1 − t / (2 |T − P|)."),
        new Mistake("noclamp", Affects.Color, Slides.Template, "nothing is clamped to 0 … 1, so that a byte wraps round",
            Wraps(channel => channel),
            "The brightest or the farthest places have wild colours.",
            "What does a cast to byte make of 306, and what of −25?",
            "Clamp each channel to 0 … 1 before you multiply by 255.")
            .Or("the attenuation is not below 0, but a channel over 1 wraps round", Wraps(channel => Math.Max(channel, 0)))
            .Or("only what is less than 0 is not clamped", Wraps(channel => Math.Min(channel, 1))),
        new("x256", Affects.Color, Slides.Template, "256 · channel",
            lab => lab.Byte.Is(channel => (byte)Math.Min(256 * channel, 255)),
            "Many channels differ by one level.",
            "What is the greatest number in a byte?",
            "(byte)(255 · channel + 0.5), the channel between 0 and 1.", isWithinRounding: true),
        new("round", Affects.Color, Slides.Template, "(byte)(255 · channel): truncated, not rounded",
            lab => lab.Byte.Is(channel => (byte)(255 * channel)),
            "Many channels are one level too low.",
            "What does a cast to byte do with 127.9?",
            "(byte)(255 · channel + 0.5).", isWithinRounding: true),
        new Mistake("gamma", Affects.Color, Slides.Template, "a gamma of 2: the root of each channel",
            lab => lab.Clamp.Becomes(clamp => channel => Math.Sqrt(clamp(channel))),
            "The picture is too bright and pale; black and full light are right.",
            "Is there anything between the channel and × 255?",
            "No gamma: the channel between 0 and 1, times 255, rounded.")
            .Or(from gamma in (double[])[2.2, 1.8] select (FormattableString.Invariant($"a gamma of {gamma}"), Gamma(1 / gamma)))
            .Or("the gamma of sRGB", lab => lab.Clamp.Becomes(clamp => channel => SrgbOf(clamp(channel))))
            .Or("a gamma of 2 the wrong way: each channel squared", Gamma(2))
            .Or("a gamma of 2.2 the wrong way", Gamma(2.2)),
        new("ppm-255", Affects.Color, Slides.Template, "255 forgotten: each channel cut to 0 or 1 before it is multiplied",
            lab => lab.Byte.Is(channel => (byte)(255 * (int)channel)),
            "The picture is black but for places in full light.",
            "What is (int)0.7?",
            "First times 255, then the cast: (byte)(255 · channel + 0.5)."),
    ];

    /// <summary>Another attenuation, from t, |T − P| and the camera.</summary>
    private static Action<Lab> Fade(Func<double, double, Camera, double> attenuation) => lab =>
        lab.Attenuation.Is(t => attenuation(t, lab.FadeDistance.Do() / 2, lab.Camera));

    private static Action<Lab> Gamma(double exponent) => lab => lab.Clamp.Becomes(clamp => channel => Math.Pow(clamp(channel), exponent));

    /// <summary>The attenuation is not kept from falling below 0, the channel is clamped otherwise, and its level wraps round.</summary>
    private static Action<Lab> Wraps(Func<double, double> clamp) => lab =>
    {
        lab.Dark.Is(attenuation => attenuation);
        lab.Clamp.Is(clamp);
        lab.Byte.Is(channel => unchecked((byte)(int)(255 * channel + 0.5))); // 0 for NaN
    };

    /// <summary>What sRGB (IEC 61966-2-1) stores for a linear channel.</summary>
    private static double SrgbOf(double c) => c <= 0.0031308 ? 12.92 * c : 1.055 * Math.Pow(c, 1 / 2.4) - 0.055;
}
