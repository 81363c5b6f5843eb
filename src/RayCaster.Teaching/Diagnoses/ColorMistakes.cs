namespace RayCaster.Teaching;

/// <summary>Between a hit and three bytes.</summary>
internal static class ColorMistakes
{
    public static Mistake[] All =>
    [
        new("att-depth", Concerns.Color, Slides.Attenuation, "attenuation by the depth t · (−d·W), not by t",
            lab => lab.Distance.Becomes(_ => lab.Depth))
        {
            Hint = new("The borders of the picture are too bright; all places are right.",
                "From where does the attenuation measure: from the camera, or from a plane through it?",
                "1 − t / (2 |T − P|), with t itself."),
        },
        new("att-no2", Concerns.Color, Slides.Attenuation, "1 − t / |T − P|: the 2 is missing",
            lab => lab.Attenuation.Becomes(fade => t => fade(2 * t)))
        {
            Hint = new("The picture is too dark, and black from the target on.",
                "How bright should the target be?",
                "1 − t / (2 |T − P|): the target has half of its light."),
        },
        new("att-inv", Concerns.Color, Slides.Attenuation, "t / (2 |T − P|): far is bright",
            lab => lab.Attenuation.Becomes(fade => t => 1 - fade(t)))
        {
            Hint = new("Far things are brighter than near ones.",
                "How bright should a thing at t = 0 be?",
                "1 − t / (2 |T − P|)."),
        },
        new("att-none", Concerns.Color, Slides.Attenuation, "no attenuation: the model's colour as it is",
            lab => lab.Attenuation.Becomes(_ => _ => 1))
        {
            Rewrites = true,
            Hint = new("Everything is flat: each model has one colour.",
                "What makes a farther hit darker?",
                "colour = (1 − t / (2 |T − P|)) · the model's colour."),
        },
        new("att-origin", Concerns.Color, Slides.Attenuation, "attenuation by the hit's distance from the origin of the world",
            lab => lab.Distance.Becomes(_ => (t, d) => lab.Length.Do(lab.P + t * d)))
        {
            Rewrites = true,
            Hint = new("What is close to the point (0, 0, 0) is bright, wherever the camera is.",
                "|X| is the distance of X from which point?",
                "1 − t / (2 |T − P|): t is the distance from the camera."),
        },
        new("att-int", Concerns.Color, Slides.Attenuation, "the attenuation cut to an integer: 0",
            lab => lab.Attenuation.Becomes(fade => t => Math.Truncate(fade(t))))
        {
            Hint = new("Every model is black.",
                "Of which type is your attenuation, and what is (int)0.7?",
                "Compute in double up to the byte, and only then cast."),
        },
        new Mistake("noclamp", Concerns.Color, Slides.Picture, "nothing is clamped to 0 … 1, so that a byte wraps round",
            lab =>
            {
                lab.Dark.Becomes(_ => attenuation => attenuation);
                lab.Clamp.Becomes(_ => channel => channel);
                lab.Byte.Becomes(_ => channel => Wrapped(255 * channel + 0.5));
            })
        {
            Rewrites = true,
            Hint = new("The brightest or the farthest places have wild colours.",
                "What does a cast to byte make of 306, and what of −25?",
                "Clamp each channel to 0 … 1 before you multiply by 255."),
        }
        .Or("the same, and truncated",
            lab =>
            {
                lab.Dark.Becomes(_ => attenuation => attenuation);
                lab.Clamp.Becomes(_ => channel => channel);
                lab.Byte.Becomes(_ => channel => Wrapped(255 * channel));
            }),
        new("x256", Concerns.Color, Slides.Picture, "256 · channel",
            lab => lab.Byte.Becomes(_ => channel => (byte)Math.Min(256 * channel, 255)))
        {
            Rewrites = true,
            IsWithinRounding = true,
            Hint = new("Many channels differ by one level.",
                "What is the greatest number in a byte?",
                "(byte)(255 · channel + 0.5), the channel between 0 and 1."),
        },
        new("round", Concerns.Color, Slides.Picture, "(byte)(255 · channel): truncated, not rounded",
            lab => lab.Byte.Becomes(_ => channel => (byte)(255 * channel)))
        {
            Rewrites = true,
            IsWithinRounding = true,
            Hint = new("Many channels are one level too low.",
                "What does a cast to byte do with 127.9?",
                "(byte)(255 · channel + 0.5)."),
        },
        new Mistake("gamma", Concerns.Color, Slides.Picture, "a gamma of 2: the root of each channel",
            lab => lab.Clamp.Becomes(clamp => channel => Math.Sqrt(clamp(channel))))
        {
            Hint = new("The picture is too bright and pale; black and full light are right.",
                "Is there anything between the channel and × 255?",
                "No gamma: the channel between 0 and 1, times 255, rounded."),
        }
        .Or("a gamma of 2.2", lab => lab.Clamp.Becomes(clamp => channel => Math.Pow(clamp(channel), 1 / 2.2))),
        new Mistake("ppm-255", Concerns.Color, Slides.Picture, "255 forgotten: each channel cut to 0 or 1 before it is multiplied",
            lab => lab.Byte.Becomes(_ => channel => (byte)(255 * (int)channel)))
        {
            Rewrites = true,
            Hint = new("The picture is black but for places in full light.",
                "What is (int)0.7?",
                "First times 255, then the cast: (byte)(255 · channel + 0.5)."),
        }
        .Or("255 forgotten: (byte)channel, 0 or 1 of 255", lab => lab.Byte.Becomes(_ => channel => (byte)channel))
        .Or("255 forgotten: each channel rounded to 0 or 1 of 1",
            lab => lab.Byte.Becomes(_ => channel => (byte)(255 * (int)(channel + 0.5)))),
    ];

    /// <summary>The lowest eight bits of the whole part; 0 for no number.</summary>
    private static byte Wrapped(double level) => unchecked((byte)(int)level);
}
