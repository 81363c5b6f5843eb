namespace RayCaster;

/// <summary>What zNear and zFar measure.</summary>
public enum ClipMode
{
    /// <summary>The depth along the view direction: the clip planes are planes.</summary>
    Depth,

    /// <summary>The distance from the camera: the clip "planes" are spheres.</summary>
    Distance,
}

/// <summary>Where in its pixel a ray passes.</summary>
public enum PixelSample
{
    /// <summary>Through the pixel's lower left corner, as on the slide.</summary>
    Corner,

    /// <summary>Through the pixel's middle.</summary>
    Center,
}

/// <summary>The numbers that define a camera, with the defaults of a scene file.</summary>
/// <param name="Position">P, where the rays start.</param>
/// <param name="Target">T, different from P: the camera looks at it.</param>
public sealed record CameraParameters(Vector3 Position, Vector3 Target)
{
    /// <summary>The direction that is up in the picture; any length but zero, not parallel to T − P.</summary>
    public Vector3 Up { get; init; } = new(0, 0, 1);

    /// <summary>The angle from the picture's lower to its upper edge, in degrees, 0 &lt; fovY &lt; 180.</summary>
    public double FovY { get; init; } = 45;

    /// <summary>Pixels in a row.</summary>
    public int Width { get; init; } = 500;

    /// <summary>Rows.</summary>
    public int Height { get; init; } = 500;

    /// <summary>A hit counts if its z is at least this.</summary>
    public double ZNear { get; init; } = 0.01;

    /// <summary>A hit counts if its z is at most this.</summary>
    public double ZFar { get; init; } = 100;

    /// <summary>A hit counts if t &gt; bias; with a bias of 0, if t ≥ 0.</summary>
    public double Bias { get; init; } = 1e-6;

    /// <summary>Whether z, which zNear and zFar limit, is a depth or a distance.</summary>
    public ClipMode Clip { get; init; } = ClipMode.Depth;

    /// <summary>Where in its pixel a ray passes.</summary>
    public PixelSample Sample { get; init; } = PixelSample.Corner;
}
