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

    private Vector3 w, u, v; // fields, because each setter would be compiled for the first picture
    private double planeHeight, planeWidth, fadeDistance;
    private ClipRange clipRange;

    /// <summary>A camera; what is not set is as in a scene file that leaves it out.</summary>
    public Camera(Vector3 position, Vector3 target) => (Position, Target) = (position, target);

    /// <summary>P, where the rays start.</summary>
    public Vector3 Position { get; init { field = value; Derive(); } }

    /// <summary>T, different from P: the camera looks at it.</summary>
    public Vector3 Target { get; init { field = value; Derive(); } }

    /// <summary>The direction that is up in the picture; any length but zero, not parallel to T − P.</summary>
    public Vector3 Up { get; init { field = value; Derive(); } } = new(0, 0, 1);

    /// <summary>The angle from the picture's lower to its upper edge, in degrees, 0 &lt; fovY &lt; 180.</summary>
    public double FovY { get; init { field = value; Derive(); } } = 45;

    /// <summary>Pixels in a row.</summary>
    public int Width { get; init { field = value; Derive(); } } = 500;

    /// <summary>Rows.</summary>
    public int Height { get; init { field = value; Derive(); } } = 500;

    /// <summary>A hit counts if its z is at least this.</summary>
    public double ZNear { get; init { field = value; Derive(); } } = 0.01;

    /// <summary>A hit counts if its z is at most this.</summary>
    public double ZFar { get; init { field = value; Derive(); } } = 100;

    /// <summary>A hit counts if t &gt; bias; with a bias of 0, if t ≥ 0.</summary>
    public double Bias { get; init { field = value; Derive(); } } = 1e-6;

    /// <summary>Whether z, which zNear and zFar limit, is a depth or a distance.</summary>
    public ClipMode Clip { get; init; }

    /// <summary>Where in its pixel a ray passes.</summary>
    public PixelSample Sample { get; init; }

    /// <summary>W = −(T − P) normalised: backwards. W, U, V and h are NaN or infinite if they cannot be computed
    /// (<see cref="ValidationError"/>).</summary>
    public Vector3 W => w;

    /// <summary>U = (up × W) normalised: to the right.</summary>
    public Vector3 U => u;

    /// <summary>V = W × U: upwards, across the view.</summary>
    public Vector3 V => v;

    /// <summary>h = 2 tan(fovY / 2): the height of the picture plane at distance 1.</summary>
    public double PlaneHeight => planeHeight;

    /// <summary>w = h · width / height.</summary>
    public double PlaneWidth => planeWidth;

    /// <summary>2 |T − P|: attenuation reaches 0 at this distance, and everything beyond it is black.</summary>
    public double FadeDistance => fadeDistance;

    /// <summary>Decides by bias, zNear and zFar which crossings count.</summary>
    public ClipRange ClipRange => clipRange;

    /// <summary>Why this camera cannot take a picture, in words; null if it can.</summary>
    public string? ValidationError
    {
        get
        {
            string? error = null;
            Check("", (setting, message) => error ??= setting + FormattableString.Invariant(message));
            return error;
        }
    }

    /// <summary>Checks the settings.</summary>
    /// <param name="prefix">Stands before the names of settings in a message.</param>
    /// <param name="refuse">Called for each mistake, with the setting and a message that follows its name.</param>
    public void Check(string prefix, Action<string, FormattableString> refuse)
    {
        var view = Target - Position;
        if (view.Length == 0) refuse("target", $" must differ from {prefix}position, but both are {Target}");
        else if (double.IsInfinity(view.Length)) refuse("target", $" is {Target}, too far from {prefix}position, {Position}");
        else if ((Up % view.Normalized).Length <= 1e-12 * Up.Length) // whatever the length of up
            refuse("up", $" must not be parallel to {prefix}target - {prefix}position, but is {Up}");
        if (FovY is <= 0 or >= 180) refuse("fovY", $" must be greater than 0 and less than 180, but is {FovY}");
        if (ZFar <= ZNear) refuse("zFar", $" must be greater than {prefix}zNear, which is {ZNear}, but is {ZFar}");
        if ((long)Width * Height > MaxPixels)
            refuse("height", $" times {prefix}width must be at most {MaxPixels:N0}, but is {Height} x {Width} = {(long)Width * Height:N0}");
    }

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

    /// <summary>Computes what depends on the settings, after a change of one.</summary>
    private void Derive()
    {
        w = -(Target - Position).Normalized;
        u = (Up % w).Normalized;
        v = w % u;
        planeHeight = 2 * Math.Tan(FovY / 2 * Math.PI / 180); // FovY is in degrees, Math.Tan takes radians
        planeWidth = planeHeight * Width / Height; // not planeHeight * (Width / Height): of two integers that is a whole number
        fadeDistance = (2 * (Target - Position)).Length;
        clipRange = new(Bias, ZNear, ZFar);
    }
}
