namespace RayCaster;

/// <summary>What a model is called in texts for people.</summary>
internal static class ModelName
{
    /// <summary>The background's name.</summary>
    public const string Background = "the background";

    /// <summary>Its name between backquotes; where it has none, or shares it, its place in the scene file and its type.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="model">The model's place; −1 for the background.</param>
    public static string Of(Scene scene, int model)
    {
        if (model < 0) return Background;
        var place = $"models[{model}]";
        if (string.IsNullOrEmpty(scene.Models[model].Name)) return $"{place} ({TypeOf(scene.Models[model])})";
        var name = $"`{scene.Models[model].Name}`";
        for (var i = 0; i < scene.Models.Count; i++)
            if (i != model && scene.Models[i].Name == scene.Models[model].Name) return $"{name} ({place})";
        return name;
    }

    /// <summary>The type as a scene file names it; the class's name for a model that no scene file knows.</summary>
    public static string TypeOf(Model model)
    {
        var type = model.GetType();
        return (type.IsGenericType ? type.GenericTypeArguments[0] : type).Name.ToLowerInvariant();
    }
}
