namespace RayCaster.Teaching;

/// <summary>The steps of a pixel's explanation that are not those of a model.</summary>
internal static class PixelSteps
{
    /// <summary>W, U, V, h and w, which are the same for all pixels.</summary>
    public static IReadOnlyList<FormulaStep> OfCamera(Camera camera)
    {
        var (P, T, up) = (Digits.Of(camera.Position), Digits.Of(camera.Target), Digits.Of(camera.Up));
        return
        [
            new("W", "−(T − P) normalised", $"−({T} − {P}) / {Digits.Of((camera.Target - camera.Position).Length)}", camera.W),
            new("U", "(up × W) normalised", $"{up} × {Digits.Of(camera.W)} / {Digits.Of((camera.Up % camera.W).Length)}", camera.U),
            new("V", "W × U", $"{Digits.Of(camera.W)} × {Digits.Of(camera.U)}", camera.V),
            new("h", "2 tan(fovY / 2)", $"2 · tan({Digits.Of(camera.FovY)}° / 2)", camera.PlaneHeight),
            new("w", "h · width / height", $"{Digits.Of(camera.PlaneHeight)} · {camera.Width} / {camera.Height}", camera.PlaneWidth),
        ];
    }

    /// <summary>The steps from the pixel to the direction of its ray.</summary>
    public static IReadOnlyList<FormulaStep> OfRay(Camera camera, int column, int row)
    {
        var d = camera.Direction(((Derivation)column).As("c", ""), ((Derivation)row).As("r", ""));
        return FormulaStep.LeadingTo(d.X, d.Y, d.Z);
    }

    /// <summary>The steps from the hit to the channels, and from the channels to their levels.</summary>
    public static (IReadOnlyList<FormulaStep> Attenuation, IReadOnlyList<FormulaStep> Color, Color Value) OfColor(Scene scene, Ray ray)
    {
        if (ray.HitModel is not { } model)
        {
            var (r, g, b) = scene.Background;
            return ([], Channels("background", r, g, b), scene.Background);
        }
        var attenuation = scene.Attenuation(((Derivation)ray.HitParameter).As("t", ""));
        Derivation red = attenuation * model.Color.R, green = attenuation * model.Color.G, blue = attenuation * model.Color.B;
        return (FormulaStep.LeadingTo(attenuation), Channels("attenuation * color", red, green, blue), new(red.Value, green.Value, blue.Value));
    }

    private static List<FormulaStep> Channels(string formula, Derivation red, Derivation green, Derivation blue)
    {
        (red, green, blue) = (red.As("red", $"{formula}.R"), green.As("green", $"{formula}.G"), blue.As("blue", $"{formula}.B"));
        return [.. FormulaStep.LeadingTo(Level(red, "red"), Level(green, "green"), Level(blue, "blue"))
            .Where(step => step.Name != "attenuation")];
    }

    private static Derivation Level(Derivation channel, string name) =>
        Color.Level(channel).As($"{name} level", $"min(max({name}, 0), 1) * 255 + 0.5");
}
