namespace RayCaster.Teaching;

/// <summary>The names of models in texts for people.</summary>
public static class ModelName
{
    /// <summary>What a ray sees that hits nothing.</summary>
    public const string Background = "the background";

    /// <summary>For a sentence: the name in backquotes. A model without a name of its own gets its path in the scene file and its type.</summary>
    /// <param name="model">The model's index; −1 for the background.</param>
    public static string Format(Scene scene, int model)
    {
        if (model < 0) return Background;
        if (string.IsNullOrEmpty(scene.Models[model].Name)) return Typed(scene, model);
        var name = $"`{scene.Models[model].Name}`";
        return scene.Models.Count(other => other.Name == scene.Models[model].Name) > 1 ? $"{name} (models[{model}])" : name;
    }

    /// <summary>For a table: the name, or path and type.</summary>
    public static string Typed(Scene scene, int model) =>
        scene.Models[model].Name is { Length: > 0 } name ? name : $"models[{model}] ({scene.Models[model].Kind})";

    /// <summary>For a text that also has the type: the name, or the path.</summary>
    /// <param name="model">The model's index; −1 for the background.</param>
    public static string Plain(Scene scene, int model) =>
        model < 0 ? Background : scene.Models[model].Name is { Length: > 0 } name ? name : $"models[{model}]";
}
