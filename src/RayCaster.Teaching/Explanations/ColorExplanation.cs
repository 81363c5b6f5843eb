namespace RayCaster.Teaching;

/// <summary>The colour's part of an explanation.</summary>
internal static class ColorExplanation
{
    /// <summary>The steps from the hit to the channels, and from the channels to their levels.</summary>
    public static (IReadOnlyList<FormulaStep> Attenuation, IReadOnlyList<FormulaStep> Color, Color Value) Of(Scene scene, Ray ray)
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
