namespace RayCaster.Live;

/// <summary>What a page looks at: its own camera, and which models.</summary>
/// <param name="Camera">The camera; null for the scene's own.</param>
/// <param name="Divisor">The picture is so many times smaller in each direction, while it moves.</param>
/// <param name="Hidden">The places of the models that are left out, as "2,5".</param>
/// <param name="Look">How one model is looked at.</param>
/// <param name="Model">Which.</param>
internal sealed record View(Camera? Camera = null, int Divisor = 1, string Hidden = "", Look Look = Look.Plain, int Model = -1)
{
    /// <summary>The most pixels that a page shows; larger pictures are drawn smaller.</summary>
    public const int MostPixels = 4_000_000;

    /// <summary>The longest side of a canvas that every browser shows.</summary>
    private const int MostSide = 8000;

    private static readonly Mesh nothing = new([], []);

    /// <summary>The scene as it is looked at. A model that is left out becomes one of nothing, so that the others keep their places.</summary>
    public Scene Of(Scene scene)
    {
        var (width, height) = SizeOf(scene.Camera);
        var camera = (Camera ?? scene.Camera).WithSize(Math.Max(1, width / Divisor), Math.Max(1, height / Divisor));
        if (Hidden.Length == 0) return scene with { Camera = camera };
        var models = scene.Models.ToArray();
        foreach (var place in Hidden.Split(',').Select(int.Parse))
            if (place < models.Length)
                models[place] = nothing;
        return scene with { Camera = camera, Models = models };
    }

    /// <summary>The size at which a page shows a scene's picture.</summary>
    public static (int Width, int Height) SizeOf(Camera camera)
    {
        var pixels = (double)camera.Width * camera.Height;
        var divisor = Math.Max((int)Math.Ceiling(Math.Sqrt(pixels / MostPixels)), (Math.Max(camera.Width, camera.Height) - 1) / MostSide + 1);
        return (Math.Max(1, camera.Width / divisor), Math.Max(1, camera.Height / divisor));
    }
}
