namespace RayCaster.Engine;

/// <summary>Finds the tiles in which a mesh's clusters may show; each thread has its own. Where a cluster's box says too little, it sorts the
/// cluster's triangles one by one.</summary>
internal sealed class ClusterBinner<N>(ScreenSpace screen, TriangleBoxes boxes, TriangleBinner each) where N : struct, IPacket<N>, IReal<N>
{
    /// <summary>In a larger rectangle of pixels the triangles are sorted one by one: they are large, or far from each other.</summary>
    private const long LargeArea = 4 * Tile.MaxSide * Tile.MaxSide;

    /// <summary>At depth 1 a ray is at least this far from the eye along the axis that it follows most: 1/√3.</summary>
    private const double MinAlong = 0.57;

    private readonly (int Axis, double At, double Right, double Up)[] mainAxes = [.. MainAxes(screen)];
    private readonly double[] left = new double[N.Count], right = new double[N.Count];
    private readonly double[] bottom = new double[N.Count], top = new double[N.Count], most = new double[N.Count];
    private int firstOfMax = -1; // the first of the clusters whose greatest inverse depth is known

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Add(int first, int end)
    {
        each.Lists.Items.Reserve(end - first);
        for (; first < end; first += N.Count)
        {
            var (fit, shows) = Project(first);
            var all = (1u << Math.Min(N.Count, end - first)) - 1;
            for (var unfit = ~fit & all; unfit != 0; unfit &= unfit - 1)
            {
                var (begin, stop) = boxes.TrianglesOf(first + BitOperations.TrailingZeroCount(unfit));
                each.Add(begin, stop);
            }
            for (shows &= all; shows != 0; shows &= shows - 1) Bin(first, BitOperations.TrailingZeroCount(shows));
        }
    }

    /// <summary>Finds the rectangles of some boxes on the screen.</summary>
    /// <remarks>
    /// Rounding moves a rectangle's sides by some 2⁻⁵³ of (distance + size) / least depth, in units of the scale; the size is held below the least
    /// depth, and so that is less than <see cref="ScreenSpace.DoubleMargin"/>, by which the formula, too, may see a corner elsewhere.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private (uint Fit, uint Shows) Project(int first)
    {
        var (low, high) = Bounds(first);
        var (center, half) = ((N)0.5 * (low + high), (N)0.5 * (high - low));
        var (nearest, farthest) = Range(-screen.Camera.W, center, half);
        var (inverse, inverseFar) = ((N)1.0 / nearest, (N)1.0 / farthest);
        var (w0, w1) = ((N)screen.ReferenceDepth * inverseFar, (N)screen.ReferenceDepth * inverse);

        N fit = (nearest > half.X + half.Y + half.Z) & (w0 > (N)1e-29) & (w1 < (N)1e29), shows = fit, size = 0.0;
        Project(screen.Camera.U, screen.CenterX, screen.Camera.Width, left, right);
        Project(screen.Camera.V, screen.CenterY, screen.Camera.Height, bottom, top);

        // The inverse depth of a sliver may be stretched; see TriangleSetUp.
        var minInverseDepth = w0 * (N)(1 - 1e-5) * ((N)1.0 - size * (N)(4 / screen.Scale));
        shows &= minInverseDepth <= (N)(double)screen.MaxInverseDepth;
        if (!Lanes.All(fit)) fit |= IsOutside(center, half);
        return (N.Bits(fit), N.Bits(shows));

        // in a larger method, the compiler would turn operators into calls
        [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
        void Project(Vector3 axis, double zero, double pixels, double[] first, double[] last)
        {
            N none = 0.0, scale = screen.Scale, middle = zero, margin = 2.0 * screen.Margin, end = pixels, guard = screen.Guard;
            var (least, most) = Range(axis, center, half);
            least = least * N.Select(least < none, inverse, inverseFar) * scale + middle - margin;
            most = most * N.Select(most < none, inverseFar, inverse) * scale + middle + margin;
            fit &= (least >= -guard) & (most <= end + guard);
            shows &= (least < end) & (most >= none);
            size += most - least;
            StoreClamped(first, least, end - (N)1.0);
            StoreClamped(last, most, end - (N)1.0);
        }
    }

    /// <summary>Finds the greatest inverse depth of hits in some boxes.</summary>
    /// <remarks>The formula finds hits, also in triangles seen edge-on, only between their corners along the axis that the ray follows most. A ray
    /// that is at a at depth 1 reaches the box's nearer side b at depth b / a, where inverse depth is a / b; over the rectangle a is greatest in a
    /// corner.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void FindMaxInverseDepth(int first)
    {
        var (low, high) = Bounds(first);
        N most = 0.0, none = 0.0, mainly = MinAlong;
        foreach (var (axis, at, right, up) in mainAxes)
        {
            var along = (N)at + (N)right * N.Load(right > 0 ? this.right : left, 0) + (N)up * N.Load(up > 0 ? top : bottom, 0);
            var isMain = along >= mainly;
            if (N.Bits(isMain) == 0) continue;
            var near = axis switch { 0 => low.X, 1 => low.Y, 2 => low.Z, 3 => -high.X, 4 => -high.Y, _ => -high.Z };
            most = N.Max(most, N.Select(isMain, N.Select(near > none, along / near, double.PositiveInfinity), none));
        }
        (most * (N)(screen.ReferenceDepth * (1 + 1e-5))).Store(this.most, 0);
        firstOfMax = first;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (Vector3<N> Low, Vector3<N> High) Bounds(int first)
    {
        N unit = boxes.Extent;
        Vector3<N> middle = boxes.Middle - screen.Camera.Position;
        return (unit * boxes.Lows<N>(first) + middle, unit * boxes.Highs<N>(first) + middle);
    }

    /// <summary>The axes (0 to 2), and the directions against them (3 to 5), that a ray may follow most, with the coordinate along them of the ray
    /// of pixel (0, 0) at depth 1, and its change from column to column and from row to row.</summary>
    private static IEnumerable<(int Axis, double At, double Right, double Up)> MainAxes(ScreenSpace screen)
    {
        var camera = screen.Camera;
        var (right, up) = (1 / screen.Scale * camera.U, 1 / screen.Scale * camera.V);
        var corner = -camera.W - screen.CenterX * right - screen.CenterY * up;
        for (var axis = 0; axis < 6; axis++)
        {
            var sign = axis < 3 ? 1 : -1;
            var (at, x, y) = (sign * Along(corner), sign * Along(right), sign * Along(up));
            if (at + Math.Max(0, x * camera.Width) + Math.Max(0, y * camera.Height) >= MinAlong) yield return (axis, at, x, y);

            double Along(Vector3 v) => (axis % 3) switch { 0 => v.X, 1 => v.Y, _ => v.Z };
        }
    }

    /// <summary>Where boxes lie on the outer side of a plane through the camera and an edge of the picture.</summary>
    /// <remarks>The planes are moved out by a pixel, which is more than any rounding.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private N IsOutside(Vector3<N> center, Vector3<N> half)
    {
        const double Margin = 1;
        var camera = screen.Camera;
        var ahead = -screen.Camera.W;
        return IsBehind(screen.Scale * camera.U + (screen.CenterX + Margin) * ahead)
            | IsBehind(-screen.Scale * camera.U + (camera.Width - screen.CenterX + Margin) * ahead)
            | IsBehind(screen.Scale * camera.V + (screen.CenterY + Margin) * ahead)
            | IsBehind(-screen.Scale * camera.V + (camera.Height - screen.CenterY + Margin) * ahead);

        N IsBehind(Vector3 normal) => Range(normal, center, half).Most < (N)0.0;
    }

    /// <summary>Stores places, moved into the picture; their whole parts are pixels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreClamped(double[] pixels, N pixel, N last) =>
        N.Select(pixel >= (N)0.0, N.Select(pixel < last, pixel, last), 0.0).Store(pixels, 0);

    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    private void Bin(int cluster, int i)
    {
        if (Math.Ceiling(left[i]) > right[i] || Math.Ceiling(bottom[i]) > top[i]) return; // between samples
        if (firstOfMax != cluster) FindMaxInverseDepth(cluster);
        if (!(most[i] >= screen.MinInverseDepth)) return;
        var (first, end) = boxes.TrianglesOf(cluster + i);
        var (x0, x1, y0, y1) = (Pixel(left[i]), Pixel(right[i]), Pixel(bottom[i]), Pixel(top[i]));
        if ((x1 - x0 + 1L) * (y1 - y0 + 1L) > LargeArea) each.Add(first, end);
        else each.Lists.Add(new(first, TriangleBoxes.ClusterLength), (float)most[i], x0, x1, y0, y1);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Pixel(double pixel) => (uint)double.ConvertToIntegerNative<int>(pixel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (N Least, N Most) Range(Vector3 axis, Vector3<N> center, Vector3<N> half)
    {
        Vector3<N> along = axis, across = new Vector3(Math.Abs(axis.X), Math.Abs(axis.Y), Math.Abs(axis.Z));
        var (middle, spread) = (center * along, half * across);
        return (middle - spread, middle + spread);
    }
}
