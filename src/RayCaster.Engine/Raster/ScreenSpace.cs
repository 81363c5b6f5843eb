namespace RayCaster.Engine;

/// <summary>Screen space: the column and row of a point (samples lie at whole numbers) and w = |T − P| / depth, which is linear over the picture on
/// every flat surface; in floats, with margins for what they and the triangle's formula round.</summary>
internal sealed class ScreenSpace
{
    private readonly Vector3 origin, u, v, w;
    private readonly Vector3 right, up, ahead; // the axes in pixels at unit depth

    public ScreenSpace(Camera camera)
    {
        (Camera, origin, u, v, w) = (camera, camera.Position, camera.U, camera.V, camera.W);
        (Scale, ReferenceDepth) = (camera.Height / camera.PlaneHeight, camera.FadeDistance / 2);
        (right, up, ahead) = (Scale / ReferenceDepth * u, Scale / ReferenceDepth * v, -w);
        (CenterX, CenterY) = (camera.Width / 2.0 - camera.SampleOffset, camera.Height / 2.0 - camera.SampleOffset);
        Guard = 256 + Math.Max(camera.Width, camera.Height) / 4.0;

        var squareOfSlope = (camera.PlaneWidth * camera.PlaneWidth + camera.PlaneHeight * camera.PlaneHeight) / 4;
        var longest = Math.Sqrt(1 + squareOfSlope) * (1 + 1e-9);
        LongestT = longest;

        // Direction, projection and formula each round by a few units of 2⁻⁵³ of an angle, or of the picture's size; an angle is at most that many
        // pixels:
        var pixelsOfAngle = Scale * (1 + squareOfSlope) + camera.Width + camera.Height;
        DoubleMargin = (1e-14 + 4 * camera.Skew) * pixelsOfAngle;
        // margins.md, 1: a float rounds by 2⁻²⁴ of a coordinate, twice.
        Margin = (float)(DoubleMargin + Math.ScaleB(Math.Max(camera.Width, camera.Height) + Guard + 2, -23));
        // margins.md, 2: in a wider triangle t is within 1e-6 of the triangle's plane.
        MinWidth = (float)(4e6 * DoubleMargin + 16 * Margin);
        IsFine = DoubleMargin < 1e-2 && camera.Skew * longest < 1e-7 && ReferenceDepth is > 1e-250 and < 1e250;

        var byDistance = camera.Clip == ClipMode.Distance;
        var nearest = Math.Max(camera.ZNear, camera.Bias);
        MinDepth = (byDistance ? nearest : Math.Max(camera.ZNear, camera.Bias / longest)) / (byDistance ? longest : 1) * (1 - 1e-6);
        MaxSureInverseDepth = (float)(ReferenceDepth / nearest * (1 - 1e-5));
        MinSureInverseDepth = (float)(ReferenceDepth / camera.ZFar * (byDistance ? longest : 1) * (1 + 1e-5));
        MaxInverseDepth = (float)(ReferenceDepth / MinDepth * (1 + 1e-5));
        MinInverseDepth = (float)(ReferenceDepth / camera.ZFar * (1 - 1e-5));
    }

    public Camera Camera { get; }

    /// <summary>Pixels for a slope of 1 against the view direction.</summary>
    public double Scale { get; }

    /// <summary>The depth at which inverse depth is 1.</summary>
    public double ReferenceDepth { get; }

    /// <summary>The column and row of the view direction.</summary>
    public double CenterX { get; }

    /// <inheritdoc cref="CenterX"/>
    public double CenterY { get; }

    /// <summary>How many pixels off the picture a corner may lie. Triangles that reach farther are clipped, so that floats stay accurate
    /// enough.</summary>
    public double Guard { get; }

    /// <summary>The greatest t of a ray at depth 1.</summary>
    public double LongestT { get; }

    /// <summary>The error of a corner and a ray in doubles, in pixels.</summary>
    public double DoubleMargin { get; }

    /// <summary>The error of a corner in floats, in pixels.</summary>
    public float Margin { get; init; }

    /// <summary>The greatest error of some float operations on numbers up to 1.</summary>
    public float Roundings { get; init; } = 1f / (1 << 20);

    /// <summary>Twice a triangle's area divided by its width and height, in pixels; from this value on, its t certainly lies on its plane.</summary>
    public float MinWidth { get; init; }

    /// <summary>Whether doubles can tell this camera's pixels apart; with a view of 1e-9 degrees they cannot.</summary>
    public bool IsFine { get; }

    /// <summary>No hit at a lesser depth counts.</summary>
    public double MinDepth { get; }

    /// <summary>Hits with an inverse depth between these certainly count.</summary>
    public float MinSureInverseDepth { get; init; }

    /// <inheritdoc cref="MinSureInverseDepth"/>
    public float MaxSureInverseDepth { get; init; }

    /// <summary>Hits with an inverse depth outside of these certainly do not count.</summary>
    public float MinInverseDepth { get; }

    /// <inheritdoc cref="MinInverseDepth"/>
    public float MaxInverseDepth { get; }

    /// <summary>A point in the camera's axes: X to the right, Y up, Z into the picture.</summary>
    public Vector3 ToCamera(Vector3 point)
    {
        var p = point - origin;
        return new(p * u, p * v, -(p * w));
    }

    /// <summary>Column, row and inverse depth of a point in the camera's axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (N X, N Y, N InverseDepth) Project<N>(N x, N y, N z) where N : struct, IReal<N>
    {
        var inverse = (N)1 / z;
        return (x * inverse * Scale + CenterX, y * inverse * Scale + CenterY, (N)ReferenceDepth * inverse);
    }

    /// <summary>Column, row and inverse depth of points.</summary>
    /// <remarks>
    /// The axes in pixels are rounded once more than those of the camera, and products and sums less often; what that changes is a few parts in 2⁵³
    /// of a coordinate, as <see cref="DoubleMargin"/> counts for any order of these steps. What overflows is not fit for floats.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (N X, N Y, N InverseDepth) Project<N>(Vector3<N> point) where N : struct, IPacket<N>, IReal<N>
    {
        var p = point - (Vector3<N>)origin;
        var inverseDepth = (N)ReferenceDepth / Along(p, ahead);
        var (column, row) = (Along(p, right), Along(p, up));
        return (N.MultiplyAddEstimate(column, inverseDepth, CenterX), N.MultiplyAddEstimate(row, inverseDepth, CenterY), inverseDepth);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static N Along<N>(Vector3<N> p, Vector3 axis) where N : struct, IPacket<N>, IReal<N> =>
        N.MultiplyAddEstimate(p.X, axis.X, N.MultiplyAddEstimate(p.Y, axis.Y, p.Z * (N)axis.Z));

    /// <summary>Where corners are fit for floats.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> IsFit(in EightPoints p)
    {
        var beyond = Vector256.Create((float)(-Guard - 1));
        return Vector256.GreaterThan(p.InverseDepth, Vector256.Create(1e-30f)) & Vector256.LessThan(p.InverseDepth, Vector256.Create(1e30f))
            & Vector256.GreaterThanOrEqual(p.X, beyond) & Vector256.LessThanOrEqual(p.X, Vector256.Create((float)(Camera.Width + Guard + 1)))
            & Vector256.GreaterThanOrEqual(p.Y, beyond) & Vector256.LessThanOrEqual(p.Y, Vector256.Create((float)(Camera.Height + Guard + 1)));
    }

    /// <inheritdoc cref="IsFit(in EightPoints)"/>
    public bool IsFit(double column, double row, double inverseDepth) =>
        inverseDepth is > 1e-30 and < 1e30 && column >= -Guard - 1 && column <= Camera.Width + Guard + 1
        && row >= -Guard - 1 && row <= Camera.Height + Guard + 1;
}
