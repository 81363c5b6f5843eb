namespace RayCaster.Engine;

/// <summary>Finds where in the picture balls and boxes may show, and how near they are, for all lanes of a packet at once.</summary>
/// <remarks>What it says is padded as <see cref="BoundsExtensions.PaddedFrom"/> says, which is enough for the roundings of the projection, too:
/// a few units of 2⁻⁵³ of the distance. What places in the picture round is a few units of its width, less than 1e-9 of a pixel.</remarks>
internal sealed class ScreenBounds
{
    private const double Margin = 0.01; // on each side, in pixels

    /// <summary>How many are processed together.</summary>
    public const int Count = 8;

    private readonly double[] x = new double[Count], y = new double[Count], z = new double[Count]; // of centres, or least coordinates
    private readonly double[] radius = new double[Count], maxX = new double[Count], maxY = new double[Count], maxZ = new double[Count];
    private readonly double[] visibility = new double[Count], nearest = new double[Count];
    private readonly double[] left = new double[Count], right = new double[Count], bottom = new double[Count], top = new double[Count];
    private readonly Camera camera;
    private readonly double sample;
    private readonly bool byDistance;
    private readonly double leftmost, rightmost, lowest, topmost; // slopes beyond which there is no pixel,
    private readonly double lengthLeft, lengthRight, lengthLow, lengthTop; // and how long (1, slope) is

    public ScreenBounds(Camera camera)
    {
        (this.camera, sample, byDistance) = (camera, camera.SampleOffset, camera.Clip == ClipMode.Distance);
        (leftmost, lengthLeft) = Slope(-1, camera.PlaneWidth, camera.Width);
        (rightmost, lengthRight) = Slope(camera.Width + 1, camera.PlaneWidth, camera.Width);
        (lowest, lengthLow) = Slope(-1, camera.PlaneHeight, camera.Height);
        (topmost, lengthTop) = Slope(camera.Height + 1, camera.PlaneHeight, camera.Height);

        static (double Slope, double Length) Slope(double pixel, double planeSize, int pixels)
        {
            var slope = planeSize * pixel / pixels - planeSize / 2;
            return (slope, Math.Sqrt(1 + slope * slope));
        }
    }

    /// <summary>What is known of a shape's place in the picture.</summary>
    private enum Visibility
    {
        /// <summary>It shows in no pixel.</summary>
        Outside,

        /// <summary>It reaches to the eye's plane, or numbers overflow.</summary>
        Unknown,

        /// <summary>It may show in a rectangle.</summary>
        Shows,

        /// <summary>It may show in a rectangle, and all of its hits certainly count.</summary>
        AllHitsCount,
    }

    /// <summary>Projects up to <see cref="Count"/> balls; <see cref="Read"/> gives the results.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Project<N>(ReadOnlySpan<(Vector3 Center, double Radius)> balls) where N : struct, IPacket<N>
    {
        for (var i = 0; i < balls.Length; i++)
        {
            ref readonly var ball = ref balls[i];
            (x[i], y[i], z[i], radius[i]) = (ball.Center.X, ball.Center.Y, ball.Center.Z, ball.Radius);
        }
        for (var i = 0; i < Count; i += N.Count)
            Store(i, Ball(new Vector3<N>(N.Load(x, i), N.Load(y, i), N.Load(z, i)), N.Load(radius, i)));
    }

    /// <summary>Projects up to <see cref="Count"/> boxes; <see cref="Read"/> gives the results.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Project<N>(ReadOnlySpan<Bounds> boxes) where N : struct, IPacket<N>
    {
        for (var i = 0; i < boxes.Length; i++)
        {
            ref readonly var box = ref boxes[i];
            (x[i], y[i], z[i]) = (box.Min.X, box.Min.Y, box.Min.Z);
            (maxX[i], maxY[i], maxZ[i]) = (box.Max.X, box.Max.Y, box.Max.Z);
        }
        for (var i = 0; i < Count; i += N.Count)
        {
            var max = new Vector3<N>(N.Load(maxX, i), N.Load(maxY, i), N.Load(maxZ, i));
            Store(i, Box(new Vector3<N>(N.Load(x, i), N.Load(y, i), N.Load(z, i)), max));
        }
    }

    /// <summary>Reads the result for one of them.</summary>
    /// <param name="nearest">No hit of it is nearer.</param>
    /// <param name="allHitsCount">Whether all of its hits certainly count.</param>
    /// <returns>Where it may show; null if that is not known, since it reaches to the eye's plane or numbers overflow.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PixelRect? Read(int i, out float nearest, out bool allHitsCount)
    {
        var visibility = (Visibility)(int)this.visibility[i];
        (nearest, allHitsCount) = ((float)this.nearest[i], visibility == Visibility.AllHitsCount);
        if (visibility == Visibility.Unknown) return null;
        if (visibility == Visibility.Outside) return default(PixelRect);
        var (column, row) = ((int)left[i], (int)bottom[i]);
        return new(column, row, (int)right[i] - column, (int)top[i] - row);
    }

    /// <summary>The pixels where something within bounds may show; everywhere if that is not known.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public PixelRect TileOf(Bounds bounds)
    {
        if (camera.IsSkewed) return PixelRect.Everywhere; // the projection would be wrong
        var projection = Box<Scalar>(bounds.Min, bounds.Max);
        var visibility = (Visibility)(int)projection.Visibility.Value;
        if (visibility == Visibility.Outside) return default;
        if (visibility == Visibility.Unknown) return PixelRect.Everywhere;
        var (column, row) = ((int)projection.Left.Value, (int)projection.Bottom.Value);
        var (width, height) = ((int)projection.Right.Value - column, (int)projection.Top.Value - row);
        return width > 0 && height > 0 ? new(column, row, width, height) : default;
    }

    /// <summary>Where a ball is seen: slopes s of the lines through the eye that touch it, (x − s z)² = r² (1 + s²).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Projection<N> Ball<N>(Vector3<N> center, N radius) where N : struct, IReal<N>
    {
        var L = center - camera.Position;
        var distance = N.Sqrt(L * L);
        var r = radius + 1e-12 * (distance + radius) + 1e-14 * (BoundsExtensions.Largest(center, center) + radius);
        var (x, y, z) = ToCamera(L);
        var difference = z * z - r * r;
        var (rootX, rootY) = (r * N.Sqrt(x * x + difference), r * N.Sqrt(y * y + difference));
        var allHitsCount = (distance - r > camera.Bias) & (byDistance
            ? (distance - r >= camera.ZNear) & (distance + r <= camera.ZFar)
            : (z - r >= camera.ZNear) & (z + r <= camera.ZFar));
        return Judged(
            IsOutside(x, y, z, r),
            0.999 * z > r, // so that the difference of squares stays accurate
            allHitsCount,
            distance - r,
            (x * z - rootX) / difference, (x * z + rootX) / difference, (y * z - rootY) / difference, (y * z + rootY) / difference);
    }

    /// <summary>Where a box is seen, by the box around it along the camera's axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Projection<N> Box<N>(Vector3<N> min, Vector3<N> max) where N : struct, IReal<N>
    {
        (min, max) = BoundsExtensions.Padded(min, max, camera.Position);
        var (L, half) = (0.5 * (min + max), 0.5 * (max - min));
        var size = new Vector3<N>(N.Max(L.X, -L.X), N.Max(L.Y, -L.Y), N.Max(L.Z, -L.Z));
        var gap = new Vector3<N>(N.Max(size.X - half.X, 0), N.Max(size.Y - half.Y, 0), N.Max(size.Z - half.Z, 0));
        var (x, y, z) = ToCamera(L);
        var (halfX, halfY, halfZ) = (Spread(half, camera.U), Spread(half, camera.V), Spread(half, camera.W));
        var (front, back) = (z - halfZ, z + halfZ);
        return Judged(
            IsOutside(x, y, z, N.Sqrt(half * half)) | (back < 0),
            front > 0,
            0, // a triangle that is seen edge-on may have a t outside of its box
            BoundsExtensions.LeastT(gap, size + half),
            (x - halfX) / N.Select(x < halfX, front, back), (x + halfX) / N.Select(x < -halfX, back, front),
            (y - halfY) / N.Select(y < halfY, front, back), (y + halfY) / N.Select(y < -halfY, back, front));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Projection<N> Judged<N>(N isOutside, N isInFront, N allHitsCount, N nearest, N left, N right, N bottom, N top) where N : struct, IReal<N>
    {
        (left, right, bottom, top) = (Column(left, -Margin), Column(right, Margin), Row(bottom, -Margin), Row(top, Margin));
        var isKnown = isInFront & (left + right + bottom + top + nearest < double.PositiveInfinity); // false for NaN
        return new()
        {
            Visibility = N.Select(isOutside, In(Visibility.Outside),
                N.Select(isKnown, N.Select(allHitsCount, In(Visibility.AllHitsCount), In(Visibility.Shows)), In(Visibility.Unknown))),
            // A float rounds it by 6e-8 of itself, or by more if it is nearly 0.
            Nearest = N.Select(nearest > 1e-37, N.Min(nearest * (1 - 1e-7), float.MaxValue), 0),
            Left = left,
            Right = right,
            Bottom = bottom,
            Top = top,
        };

        static N In(Visibility visibility) => (double)visibility;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Store<N>(int i, in Projection<N> projection) where N : struct, IPacket<N>
    {
        projection.Nearest.Store(nearest, i);
        projection.Visibility.Store(visibility, i);
        projection.Left.Store(left, i);
        projection.Right.Store(right, i);
        projection.Bottom.Store(bottom, i);
        projection.Top.Store(top, i);
    }

    /// <summary>A direction in the camera's axes, the depth last.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (N X, N Y, N Z) ToCamera<N>(Vector3<N> direction) where N : struct, IReal<N> =>
        (direction * camera.U, direction * camera.V, -(direction * camera.W));

    /// <summary>Where a ball is behind the camera, or beside all that it sees.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private N IsOutside<N>(N x, N y, N z, N radius) where N : struct, IReal<N> =>
        (z < -radius)
        | (leftmost * z - x > radius * lengthLeft) | (x - rightmost * z > radius * lengthRight)
        | (lowest * z - y > radius * lengthLow) | (y - topmost * z > radius * lengthTop);

    /// <summary>The column of a slope, rounded up when it is truncated, and within the picture.</summary>
    /// <remarks>The sample of column c lies at u = planeWidth · c / width − planeWidth / 2, half a pixel further for centres.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private N Column<N>(N slope, double beyond) where N : struct, IReal<N> =>
        N.Min(N.Max((slope / camera.PlaneWidth + 0.5) * camera.Width + (1 - sample + beyond), 0), camera.Width);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private N Row<N>(N slope, double beyond) where N : struct, IReal<N> =>
        N.Min(N.Max((slope / camera.PlaneHeight + 0.5) * camera.Height + (1 - sample + beyond), 0), camera.Height);

    /// <summary>Half the size of a box along an axis of any direction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static N Spread<N>(Vector3<N> half, Vector3 axis) where N : struct, IReal<N> =>
        Math.Abs(axis.X) * half.X + Math.Abs(axis.Y) * half.Y + Math.Abs(axis.Z) * half.Z;

    private ref struct Projection<N> where N : struct, IReal<N>
    {
        public N Visibility, Nearest, Left, Right, Bottom, Top;
    }
}
