namespace RayCaster.Teaching.Explanations;

/// <summary>The steps of a pixel's explanation that are not those of a model.</summary>
internal static class PixelSteps
{
    /// <summary>W, U, V, h and w, which are the same for all pixels.</summary>
    public static IReadOnlyList<NamedValue> OfCamera(Camera camera)
    {
        var P = Digits.Format(camera.Position);
        var T = Digits.Format(camera.Target);
        var up = Digits.Format(camera.Up);
        return
        [
            new("W", "−(T − P) normalised", $"−({T} − {P}) / {Digits.Format((camera.Target - camera.Position).Length)}", camera.W),
            new("U", "(up × W) normalised", $"{up} × {Digits.Format(camera.W)} / {Digits.Format((camera.Up % camera.W).Length)}", camera.U),
            new("V", "W × U", $"{Digits.Format(camera.W)} × {Digits.Format(camera.U)}", camera.V),
            new("h", "2 tan(fovY / 2)", $"2 · tan({Digits.Format(camera.FovY)}° / 2)", camera.PlaneHeight),
            new("w", "h · width / height", $"{Digits.Format(camera.PlaneHeight)} · {camera.Width} / {camera.Height}", camera.PlaneWidth),
        ];
    }

    /// <summary>The steps from the pixel to the direction of its ray.</summary>
    public static IReadOnlyList<NamedValue> OfRay(Camera camera, int column, int row)
    {
        var d = camera.Direction(((Derivation)column).As("c", ""), ((Derivation)row).As("r", ""));
        var steps = NamedValue.LeadingTo(d.X, d.Y, d.Z);
        var pixel = steps.FirstOrDefault(step => step.Name == "pixel")?.Formula; // the slide has no name for it
        return [.. steps.Select(step => step with { Formula = step.Formula.Replace("pixel normalised", $"({pixel}) normalised") })];
    }

    /// <summary>The steps from the hit to the channels' levels, and the colour before it is clamped.</summary>
    public static (IReadOnlyList<NamedValue> Steps, Color Color) OfColor(Scene scene, Hit hit)
    {
        if (hit.Model < 0) return OfChannels("background", scene.Background.R, scene.Background.G, scene.Background.B);
        var attenuation = scene.Attenuation(((Derivation)hit.T).As("t", ""));
        var color = scene.Models[hit.Model].Color;
        return OfChannels("attenuation * color", attenuation * color.R, attenuation * color.G, attenuation * color.B);
    }

    private static (IReadOnlyList<NamedValue>, Color) OfChannels(string formula, Derivation red, Derivation green, Derivation blue)
    {
        (red, green, blue) = (red.As("red", $"{formula}.R"), green.As("green", $"{formula}.G"), blue.As("blue", $"{formula}.B"));
        return (NamedValue.LeadingTo(Level(red, "red"), Level(green, "green"), Level(blue, "blue")), new(red.Value, green.Value, blue.Value));
    }

    private static Derivation Level(Derivation channel, string name) =>
        Color.Level(channel).As($"{name} level", $"min(max({name}, 0), 1) * 255 + 0.5");
}
