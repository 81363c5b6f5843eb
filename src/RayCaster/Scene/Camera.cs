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

/// <summary>A camera: turns a pixel into a ray (slides "Camera" and "Camera Pixel Translation").</summary>
public sealed record Camera
{
    /// <summary>The most pixels in a row, and the most rows.</summary>
    public const int MaxSide = 1_000_000;

    /// <summary>The most pixels in all.</summary>
    public const long MaxPixels = 10_000_000_000;

    /// <summary>A camera; the defaults are those of a scene file.</summary>
    /// <param name="up">(0, 0, 1) if left out.</param>
    public Camera(Vector3 position, Vector3 target, Vector3? up = null, double fovY = 45, int width = 500, int height = 500,
        double zNear = 0.01, double zFar = 100, double bias = 1e-6, ClipMode clip = ClipMode.Depth, PixelSample sample = PixelSample.Corner)
    {
        (Position, Target, Up, FovY, Width, Height) = (position, target, up ?? new(0, 0, 1), fovY, width, height);
        (ZNear, ZFar, Bias, Clip, Sample) = (zNear, zFar, bias, clip, sample);

        W = -(Target - Position).Normalized;
        U = (Up % W).Normalized;
        V = W % U;
        PlaneHeight = 2 * Math.Tan(FovY / 2 * Math.PI / 180); // FovY is in degrees, Math.Tan takes radians
        PlaneWidth = PlaneHeight * Width / Height; // not PlaneHeight * (Width / Height): of two integers that is a whole number
        FadeDistance = (2 * (Target - Position)).Length;
        ClipRange = new(Bias, ZNear, ZFar);
    }

    /// <summary>The same camera with some numbers changed.</summary>
    public Camera With(Vector3? position = null, Vector3? target = null, Vector3? up = null, double? fovY = null, int? width = null,
        int? height = null, double? zNear = null, double? zFar = null, double? bias = null, ClipMode? clip = null, PixelSample? sample = null) =>
        new(position ?? Position, target ?? Target, up ?? Up, fovY ?? FovY, width ?? Width, height ?? Height,
            zNear ?? ZNear, zFar ?? ZFar, bias ?? Bias, clip ?? Clip, sample ?? Sample);

    /// <summary>P, where the rays start.</summary>
    public Vector3 Position { get; }

    /// <summary>T, different from P: the camera looks at it.</summary>
    public Vector3 Target { get; }

    /// <summary>The direction that is up in the picture; any length but zero, not parallel to T − P.</summary>
    public Vector3 Up { get; }

    /// <summary>The angle from the picture's lower to its upper edge, in degrees, 0 &lt; fovY &lt; 180.</summary>
    public double FovY { get; }

    /// <summary>Pixels in a row.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>A hit counts if its z is at least this.</summary>
    public double ZNear { get; }

    /// <summary>A hit counts if its z is at most this.</summary>
    public double ZFar { get; }

    /// <summary>A hit counts if t &gt; bias; with a bias of 0, if t ≥ 0.</summary>
    public double Bias { get; }

    /// <summary>Whether z, which zNear and zFar limit, is a depth or a distance.</summary>
    public ClipMode Clip { get; }

    /// <summary>Where in its pixel a ray passes.</summary>
    public PixelSample Sample { get; }

    /// <summary>W = −(T − P) normalised: backwards. W, U, V and h are NaN or infinite if they cannot be computed
    /// (<see cref="ValidationError"/>).</summary>
    public Vector3 W { get; }

    /// <summary>U = (up × W) normalised: to the right.</summary>
    public Vector3 U { get; }

    /// <summary>V = W × U: upwards, across the view.</summary>
    public Vector3 V { get; }

    /// <summary>h = 2 tan(fovY / 2): the height of the picture plane at distance 1.</summary>
    public double PlaneHeight { get; }

    /// <summary>w = h · width / height.</summary>
    public double PlaneWidth { get; }

    /// <summary>2 |T − P|: attenuation reaches 0 at this distance, and everything beyond it is black.</summary>
    public double FadeDistance { get; }

    /// <summary>Decides by bias, zNear and zFar which crossings count.</summary>
    public ClipRange ClipRange { get; }

    /// <summary>Why this camera cannot take a picture, in words; null if it can.</summary>
    public string? ValidationError
    {
        get
        {
            var view = Target - Position;
            return view.Length == 0 ? $"the camera is at its target, {Target}"
                : !double.IsFinite(view.Length) ? $"the camera is at {Position}, too far from its target {Target}"
                : IsParallel(Up, view) ? $"the camera at {Position} looks along up, which is {Up}"
                : !(FovY > 0 && FovY < 180) ? FormattableString.Invariant($"fovY is {FovY}, but must be between 0 and 180")
                : null;
        }
    }

    /// <summary>Whether up and the view direction are parallel: |up × W| ≤ 1e-12 · |up|. The lengths of both do not matter.</summary>
    public static bool IsParallel(Vector3 up, Vector3 view) => (up % view.Normalized).Length <= 1e-12 * up.Length;

    /// <summary>The ray of a pixel.</summary>
    /// <param name="column">c, from the left, from 0.</param>
    /// <param name="row">r, from the bottom, from 0: line y of the picture is row Height − 1 − y.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ray RayThrough(int column, int row)
    {
        var d = Direction<Scalar>(column, row);
        return new Ray(Position, new(d.X, d.Y, d.Z)) { ClipRange = ClipRange, DepthPerT = DepthPerT(d) };
    }

    /// <summary>d = (uc U + ur V − W) normalised.</summary>
    /// <param name="c">The column; any kind of number.</param>
    /// <param name="r">The row, from the bottom.</param>
    public Vector3<N> Direction<N>(N c, N r) where N : struct, IReal<N> => Direction(Across(c), Upwards(r));

    /// <summary>The same from uc U and ur V, for a caller that computes many rays of one column or row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Direction<N>(Vector3<N> across, Vector3<N> upwards) where N : struct, IReal<N>
    {
        var pixel = (across + upwards - W).As("pixel", "uc * U + ur * V - W"); // to the picture plane; explanations print this text
        return (pixel / N.Sqrt(pixel * pixel)).As("d");
    }

    /// <summary>uc U, where uc = w c / width − w / 2.</summary>
    /// <param name="c">The column; any kind of number.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Across<N>(N c) where N : struct, IReal<N>
    {
        if (Sample == PixelSample.Center) c += 0.5;
        var uc = (PlaneWidth * c / Width - PlaneWidth / 2).As("uc");
        return uc * (Vector3<N>)U;
    }

    /// <summary>ur V, where ur = h r / height − h / 2.</summary>
    /// <param name="r">The row, from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Upwards<N>(N r) where N : struct, IReal<N>
    {
        if (Sample == PixelSample.Center) r += 0.5;
        var ur = (PlaneHeight * r / Height - PlaneHeight / 2).As("ur");
        return ur * (Vector3<N>)V;
    }

    /// <summary>The depth z per unit of t along d: −d·W; 1 if zNear and zFar limit the distance.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N DepthPerT<N>(Vector3<N> direction) where N : struct, IReal<N> =>
        Clip == ClipMode.Depth ? -(direction * W) : 1;
}
