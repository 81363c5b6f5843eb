namespace RayCaster.Page;

/// <summary>What a page looks at the scene with.</summary>
/// <param name="Camera">The camera; null for the scene's own.</param>
/// <param name="Divisor">By how much the width and the height are divided while the camera moves.</param>
internal sealed record View(Camera? Camera = null, int Divisor = 1)
{
    /// <summary>The most pixels that a page shows; larger pictures are drawn smaller.</summary>
    public const int MaxPixels = 4_000_000;

    /// <summary>The longest side of a canvas that every browser shows.</summary>
    private const int MaxSide = 8000;

    public Scene Of(Scene scene)
    {
        var (width, height) = SizeOf(scene.Camera);
        var camera = (Camera ?? scene.Camera) with { Width = Math.Max(1, width / Divisor), Height = Math.Max(1, height / Divisor) };
        return scene with { Camera = camera };
    }

    /// <summary>How many pixels the user's own picture may have: as many as the scene's, or a million, so that another size is compared.</summary>
    public static long PixelsOf(Scene? scene) => Math.Clamp((long)(scene?.Camera.Width ?? 0) * (scene?.Camera.Height ?? 0), 1_000_000, MaxPixels);

    public static (int Width, int Height) SizeOf(Camera camera)
    {
        var pixels = (double)camera.Width * camera.Height;
        var divisor = Math.Max((int)Math.Ceiling(Math.Sqrt(pixels / MaxPixels)), (Math.Max(camera.Width, camera.Height) - 1) / MaxSide + 1);
        return (Math.Max(1, camera.Width / divisor), Math.Max(1, camera.Height / divisor));
    }
}
