using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>What zNear and zFar measure.</summary>
public enum Clip
{
    /// <summary>Along the view direction: the clip planes are planes.</summary>
    Depth,

    /// <summary>From the camera: the clip "planes" are spheres.</summary>
    Distance,
}

/// <summary>Where in its pixel a ray passes.</summary>
public enum Sample
{
    /// <summary>Through the pixel's lower left corner, as on the slide.</summary>
    Corner,

    /// <summary>Through the pixel's middle.</summary>
    Center,
}

/// <summary>A camera: turns a pixel into a ray (slides "Camera" and "Ray through a pixel").</summary>
public sealed class Camera
{
    /// <summary>The most pixels in a row, and the most rows.</summary>
    public const int MaxSide = 1_000_000;

    /// <summary>The most pixels in all.</summary>
    public const long MaxPixels = 10_000_000_000;

    /// <summary>Sets up the camera's axes and the size of its picture plane; what is left out is as in a scene file.</summary>
    /// <param name="position">P.</param>
    /// <param name="target">T, different from P.</param>
    /// <param name="up">Which way is up, not parallel to T − P; any length but zero. (0, 0, 1) if left out.</param>
    /// <param name="fovY">The angle from the picture's lower to its upper edge, in degrees, 0 &lt; fovY &lt; 180.</param>
    /// <param name="width">Pixels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="zNear">Nothing nearer is seen.</param>
    /// <param name="zFar">Nothing farther is seen.</param>
    /// <param name="bias">A hit counts if t &gt; bias; with a bias of 0, if t ≥ 0.</param>
    /// <param name="clip">What zNear and zFar measure.</param>
    /// <param name="sample">Where in its pixel a ray passes.</param>
    public Camera(Vector3 position, Vector3 target, Vector3? up = null, double fovY = 45, int width = 500, int height = 500,
        double zNear = 0.01, double zFar = 100, double bias = 1e-6, Clip clip = Clip.Depth, Sample sample = Sample.Corner)
    {
        (Position, Target, Up, FovY, Width, Height) = (position, target, up ?? new Vector3(0, 0, 1), fovY, width, height);
        (ZNear, ZFar, Bias, Clip, Sample) = (zNear, zFar, bias, clip, sample);

        W = -(Target - Position).Normalized;
        U = (Up % W).Normalized;
        V = W % U;
        Skew = Math.Max(Math.Max(Math.Abs(U * W), Math.Abs(V * W)), Math.Max(Math.Abs(U * U - 1), Math.Abs(V * V - 1)));
        PlaneHeight = 2 * Math.Tan(FovY * Math.PI / 180 / 2);
        PlaneWidth = PlaneHeight * Width / Height;
        Reach = (2 * (Target - Position)).Length;
        ClipRange = new ClipRange(Bias, ZNear, ZFar);
    }

    /// <summary>P.</summary>
    public Vector3 Position { get; }

    /// <summary>T.</summary>
    public Vector3 Target { get; }

    /// <summary>Which way is up.</summary>
    public Vector3 Up { get; }

    /// <summary>The vertical field of view in degrees.</summary>
    public double FovY { get; }

    /// <summary>Pixels in a row.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>The least z that counts.</summary>
    public double ZNear { get; }

    /// <summary>The greatest z that counts.</summary>
    public double ZFar { get; }

    /// <summary>The least ray parameter that is a hit.</summary>
    public double Bias { get; }

    /// <summary>What zNear and zFar measure.</summary>
    public Clip Clip { get; }

    /// <summary>Where in its pixel a ray passes.</summary>
    public Sample Sample { get; }

    /// <summary>How far from its pixel's lower left corner a ray passes, to the right and upwards, in pixels.</summary>
    internal double SampleOffset => Sample == Sample.Center ? 0.5 : 0;

    /// <summary>W = −(T − P) normalised: backwards.</summary>
    public Vector3 W { get; }

    /// <summary>U = (up × W) normalised: to the right.</summary>
    public Vector3 U { get; }

    /// <summary>V = W × U: upwards, across the view.</summary>
    public Vector3 V { get; }

    /// <summary>h = 2 tan(fovY / 2): the height of the picture plane at distance 1.</summary>
    public double PlaneHeight { get; }

    /// <summary>w = h · width / height.</summary>
    public double PlaneWidth { get; }

    /// <summary>2 |T − P|: the distance at which all light is lost.</summary>
    public double Reach { get; }

    /// <summary>
    /// By how much U, V and W are not at right angles and of length 1. That is all rounding, but much of it where up is nearly the view
    /// direction; a ray
    /// then meets a point a little beside the pixel on which U and V put it.
    /// </summary>
    internal double Skew { get; }

    /// <summary>Whether points are put so far beside the rays that meet them that margins of 1e-12 of their distance do not make up for
    /// it.</summary>
    internal bool IsSkewed => Skew > 1e-13;

    /// <summary>Bias, zNear and zFar as one question.</summary>
    public ClipRange ClipRange { get; }

    /// <summary>Why no picture can be taken from here, in words; null where one can.</summary>
    public string? Flaw
    {
        get
        {
            var view = Target - Position;
            return view.Length == 0 ? $"the camera is at its target, {Target}"
                : !double.IsFinite(view.Length) ? $"the camera is at {Position}, too far from its target {Target}"
                : (Up % view.Normalized).Length <= 1e-12 * Up.Length ? $"the camera at {Position} looks along up, which is {Up}"
                : !(FovY > 0 && FovY < 180) ? FormattableString.Invariant($"fovY is {FovY}, but must be between 0 and 180")
                : null;
        }
    }

    /// <summary>The same camera with another number of pixels.</summary>
    public Camera WithSize(int width, int height) =>
        new(Position, Target, Up, FovY, width, height, ZNear, ZFar, Bias, Clip, Sample);

    /// <summary>The same camera at another place.</summary>
    public Camera WithView(Vector3 position, Vector3 target, double fovY) =>
        new(position, target, Up, fovY, Width, Height, ZNear, ZFar, Bias, Clip, Sample);

    /// <summary>The ray of a pixel.</summary>
    /// <param name="column">c, from the left, from 0.</param>
    /// <param name="row">r, from the bottom, from 0: line y of the picture is row Height − 1 − y.</param>
    public Ray CastRay(int column, int row)
    {
        var d = Direction<Scalar>(column, row);
        return new Ray(Position, new(d.X, d.Y, d.Z)) { Clip = ClipRange, ZPerT = ZPerT(d) };
    }

    /// <summary>d = (uc U + ur V − W) normalised.</summary>
    /// <param name="c">The column; any kind of number.</param>
    /// <param name="r">The row, from the bottom.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Direction<N>(N c, N r) where N : struct, IReal<N> => Direction(Across(c), Upwards(r));

    /// <summary>The same from its parts, for a caller that has many rays of one column and one row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vector3<N> Direction<N>(Vector3<N> across, Vector3<N> upwards) where N : struct, IReal<N>
    {
        var pixel = (across + upwards - W).As("pixel", "uc * U + ur * V - W"); // on the picture plane, seen from P
        return (pixel / N.Sqrt(pixel * pixel)).As("d");
    }

    /// <summary>uc U, where uc = w c / width − w / 2.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vector3<N> Across<N>(N c) where N : struct, IReal<N>
    {
        if (Sample == Sample.Center) c += 0.5;
        var uc = (PlaneWidth * c / Width - PlaneWidth / 2).As("uc");
        return uc * (Vector3<N>)U;
    }

    /// <summary>ur V, where ur = h r / height − h / 2.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vector3<N> Upwards<N>(N r) where N : struct, IReal<N>
    {
        if (Sample == Sample.Center) r += 0.5;
        var ur = (PlaneHeight * r / Height - PlaneHeight / 2).As("ur");
        return ur * (Vector3<N>)V;
    }

    /// <summary>What z gains for one unit of t along d: −d·W for planes across the view, 1 for spheres.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ZPerT<N>(Vector3<N> direction) where N : struct, IReal<N> =>
        Clip == Clip.Depth ? -(direction * W) : 1;
}
