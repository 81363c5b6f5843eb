using System.Runtime.CompilerServices;

namespace RayCaster.Live;

/// <summary>What a page looks at: a camera, and which models show.</summary>
/// <param name="Camera">The camera; null for the scene's own.</param>
/// <param name="Divisor">By how much the width and the height are divided while the camera moves.</param>
/// <param name="Hidden">The indices of the models that are left out, as "2,5".</param>
/// <param name="Model">The index of the model that <paramref name="Look"/> is about; −1 for none.</param>
internal sealed record View(Camera? Camera = null, int Divisor = 1, string Hidden = "", Look Look = Look.Plain, int Model = -1)
{
    /// <summary>The most pixels that a page shows; larger pictures are drawn smaller.</summary>
    public const int MaxPixels = 4_000_000;

    /// <summary>The longest side of a canvas that every browser shows.</summary>
    private const int MaxSide = 8000;

    /// <summary>The last selection of each scene's models: the renderer caches by the list, so a selection must stay the same list.</summary>
    private static readonly ConditionalWeakTable<IReadOnlyList<Model>, Selection> selections = [];

    /// <summary>The scene as the page shows it. An empty mesh takes the place of a hidden model, so that the others keep their indices.</summary>
    public Scene Of(Scene scene)
    {
        var (width, height) = SizeOf(scene.Camera);
        var camera = (Camera ?? scene.Camera).With(width: Math.Max(1, width / Divisor), height: Math.Max(1, height / Divisor));
        return scene with { Camera = camera, Models = Hidden.Length == 0 ? scene.Models : Select(scene) };
    }

    /// <summary>The size at which a page shows a scene's picture.</summary>
    public static (int Width, int Height) SizeOf(Camera camera)
    {
        var pixels = (double)camera.Width * camera.Height;
        var divisor = Math.Max((int)Math.Ceiling(Math.Sqrt(pixels / MaxPixels)), (Math.Max(camera.Width, camera.Height) - 1) / MaxSide + 1);
        return (Math.Max(1, camera.Width / divisor), Math.Max(1, camera.Height / divisor));
    }

    private Model[] Select(Scene scene)
    {
        if (selections.TryGetValue(scene.Models, out var last) && last.Hidden == Hidden) return last.Models;
        var models = scene.Models.ToArray();
        foreach (var index in Hidden.Split(',').Select(int.Parse))
            if (index < models.Length)
                models[index] = new Mesh([], []) { Name = $"{ModelName.Plain(scene, index)} (hidden)" };
        selections.AddOrUpdate(scene.Models, new(Hidden, models));
        return models;
    }

    private sealed record Selection(string Hidden, Model[] Models);
}
