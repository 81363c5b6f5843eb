using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A camera: turns a pixel into a ray (slides "Camera" and "Camera Pixel Translation").</summary>
public sealed class Camera
{
    /// <summary>The most pixels in a row, and the most rows.</summary>
    public const int MaxSide = 1_000_000;

    /// <summary>The most pixels in all.</summary>
    public const long MaxPixels = 10_000_000_000;

    /// <summary>Computes the camera's axes and the size of its picture plane. If they cannot be computed, they are NaN or infinite
    /// (<see cref="ValidationError"/>).</summary>
    public Camera(CameraParameters parameters)
    {
        Parameters = parameters;
        W = -(Target - Position).Normalized;
        U = (parameters.Up % W).Normalized;
        V = W % U;
        PlaneHeight = 2 * Math.Tan(parameters.FovY * Math.PI / 180 / 2);
        PlaneWidth = PlaneHeight * Width / Height;
        FadeDistance = (2 * (Target - Position)).Length;
        ClipRange = new ClipRange(parameters.Bias, parameters.ZNear, parameters.ZFar);
    }

    /// <summary>The numbers that define the camera. <c>new Camera(camera.Parameters with { FovY = 60 })</c> makes a changed copy.</summary>
    public CameraParameters Parameters { get; }

    /// <inheritdoc cref="CameraParameters.Position"/>
    public Vector3 Position => Parameters.Position;

    /// <inheritdoc cref="CameraParameters.Target"/>
    public Vector3 Target => Parameters.Target;

    /// <inheritdoc cref="CameraParameters.Up"/>
    public Vector3 Up => Parameters.Up;

    /// <inheritdoc cref="CameraParameters.FovY"/>
    public double FovY => Parameters.FovY;

    /// <inheritdoc cref="CameraParameters.Width"/>
    public int Width => Parameters.Width;

    /// <inheritdoc cref="CameraParameters.Height"/>
    public int Height => Parameters.Height;

    /// <inheritdoc cref="CameraParameters.ZNear"/>
    public double ZNear => Parameters.ZNear;

    /// <inheritdoc cref="CameraParameters.ZFar"/>
    public double ZFar => Parameters.ZFar;

    /// <inheritdoc cref="CameraParameters.Bias"/>
    public double Bias => Parameters.Bias;

    /// <inheritdoc cref="CameraParameters.Clip"/>
    public ClipMode Clip => Parameters.Clip;

    /// <inheritdoc cref="CameraParameters.Sample"/>
    public PixelSample Sample => Parameters.Sample;

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

    /// <summary>2 |T − P|: the distance from which on all is black.</summary>
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

    /// <summary>The same camera with another number of pixels.</summary>
    public Camera WithSize(int width, int height) => new(Parameters with { Width = width, Height = height });

    /// <summary>The ray of a pixel.</summary>
    /// <param name="column">c, from the left, from 0.</param>
    /// <param name="row">r, from the bottom, from 0: line y of the picture is row Height − 1 − y.</param>
    public Ray RayThrough(int column, int row)
    {
        var d = Direction<Scalar>(column, row);
        return new Ray(Position, new(d.X, d.Y, d.Z)) { ClipRange = ClipRange, DepthPerT = DepthPerT(d) };
    }

    /// <summary>d = (uc U + ur V − W) normalised.</summary>
    /// <param name="c">The column; any kind of number.</param>
    /// <param name="r">The row, from the bottom.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Direction<N>(N c, N r) where N : struct, IReal<N> => Direction(Across(c), Upwards(r));

    /// <summary>The same from uc U and ur V, for a caller that computes many rays of one column or row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Direction<N>(Vector3<N> across, Vector3<N> upwards) where N : struct, IReal<N>
    {
        var pixel = (across + upwards - W).As("pixel", "uc * U + ur * V - W"); // on the picture plane, seen from P
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

    /// <summary>The z of one unit of t along d: −d·W if z is the depth, 1 if it is the distance.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N DepthPerT<N>(Vector3<N> direction) where N : struct, IReal<N> =>
        Clip == ClipMode.Depth ? -(direction * W) : 1;
}
