namespace RayCaster.Engine;

/// <summary>What the filter needs of eight triangles in a tile, a triangle to a lane: the box of samples, an edge function for each side that is
/// positive inside, and inverse depth as a function of the place, all with margins.</summary>
internal struct TriangleSetUp
{
    public EightFunctions E0, E1, E2, InverseDepth;

    /// <summary>The position of the pixel of the box's lower left sample (<see cref="TilePixels.Stride"/>).</summary>
    public Vector256<int> Pixel;

    /// <summary>The number of further samples to the right and upwards.</summary>
    public Vector256<int> Across, Upwards;

    /// <summary>The error of inverse depth, and its range; the greatest inverse depth is 0 where the triangle does not show.</summary>
    public Vector256<float> Slack, MinInverseDepth, MaxInverseDepth;

    /// <summary>A sample with an edge function below the first is certainly outside; with all above the second it is certainly
    /// covered.</summary>
    public Vector256<float> Outside, Inside;

    /// <summary>Computes the fields of eight triangles and returns a bit for each that may show in the tile.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public static uint Of(TriangleQueue triangles, int first, ScreenSpace screen, in PixelRect tile, out TriangleSetUp setup)
    {
        var t = triangles.Load(first);
        Vector256<float> zero = Vector256<float>.Zero, one = Vector256<float>.One;
        var margin = Vector256.Create(screen.Margin);
        var rounding = Vector256.Create(screen.Roundings);
        var (column, row) = (Vector256.Create((float)tile.Column), Vector256.Create((float)tile.Row));
        var (ax, bx, cx) = (t.A.X - column, t.B.X - column, t.C.X - column);
        var (ay, by, cy) = (t.A.Y - row, t.B.Y - row, t.C.Y - row);
        var (left, right) = (Lanes.MinOrLast(ax, bx, cx), Lanes.MaxOrLast(ax, bx, cx));
        var (bottom, top) = (Lanes.MinOrLast(ay, by, cy), Lanes.MaxOrLast(ay, by, cy));
        var size = right - left + (top - bottom);
        left = Lanes.MaxOrLast(Vector256.Ceiling(left - margin), zero);
        right = Lanes.MinOrLast(Vector256.Floor(right + margin), Vector256.Create(tile.Width - 1f));
        bottom = Lanes.MaxOrLast(Vector256.Ceiling(bottom - margin), zero);
        top = Lanes.MinOrLast(Vector256.Floor(top + margin), Vector256.Create(tile.Height - 1f));
        var shows = Vector256.LessThanOrEqual(left, right) & Vector256.LessThanOrEqual(bottom, top);

        // An edge function of a sample s is twice the area of the triangle that s makes with a side: (b − s) × (c − s). The slack is the most by
        // which it may be wrong: 2 δ · size since the corners are off by δ, and less than 4 δ · size by rounding (margins.md, 1).
        var area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        var sign = Vector256.ConditionalSelect(Vector256.LessThan(area, zero), -one, one);
        area *= sign;
        var (e0Right, e0Up) = ((by - cy) * sign, (cx - bx) * sign);
        var (e1Right, e1Up) = ((cy - ay) * sign, (ax - cx) * sign);
        var (e2Right, e2Up) = ((ay - by) * sign, (bx - ax) * sign);
        var e0 = (left - bx) * e0Right + (bottom - by) * e0Up;
        var e1 = (left - cx) * e1Right + (bottom - cy) * e1Up;
        var e2 = (left - ax) * e2Right + (bottom - ay) * e2Up;
        var slack = Vector256.Create(6f) * margin * size;

        // The whole box, cut by the tile, may lie outside of one edge.
        var (across, upwards) = (right - left, top - bottom);
        shows &= Reaches(e0, e0Right, e0Up, across, upwards, slack) & Reaches(e1, e1Right, e1Up, across, upwards, slack)
            & Reaches(e2, e2Right, e2Up, across, upwards, slack);

        // In a triangle with next to no area the formula may find the t of any corner. So the filter takes the greatest inverse depth that a corner
        // may have along the axis that the ray follows most (margins.md, 2).
        var (maxInverseDepth, minInverseDepth) = (t.MaxInverseDepth, t.MinInverseDepth);
        var ratio = maxInverseDepth / minInverseDepth;
        var isSliver = ~Vector256.GreaterThan(area, size * Vector256.Create(screen.MinWidth) * ratio * ratio);
        var stretchedInverseDepth = StretchedInverseDepth(maxInverseDepth, size, screen);

        var slopeRight = ((t.B.InverseDepth - t.A.InverseDepth) * e1Right + (t.C.InverseDepth - t.A.InverseDepth) * e2Right) / area;
        var slopeUp = ((t.B.InverseDepth - t.A.InverseDepth) * e1Up + (t.C.InverseDepth - t.A.InverseDepth) * e2Up) / area;
        var inverseDepth = t.A.InverseDepth + (left - ax) * slopeRight + (bottom - ay) * slopeUp;
        // How far inverse depth may be wrong at a sample: margins.md, 3.
        var slope = Vector256.Abs(slopeRight) + Vector256.Abs(slopeUp);
        var inverseDepthSlack = Vector256.Create(4f) * slope * (margin + rounding * size * (one + size * size / area)) +
            Vector256.Create(4f) * rounding * maxInverseDepth;

        var counts = Vector256.LessThanOrEqual(maxInverseDepth, Vector256.Create(screen.MaxSureInverseDepth))
            & Vector256.GreaterThanOrEqual(minInverseDepth, Vector256.Create(screen.MinSureInverseDepth)) & ~isSliver;

        setup.E0 = new(e0, e0Right, e0Up);
        setup.E1 = new(e1, e1Right, e1Up);
        setup.E2 = new(e2, e2Right, e2Up);
        setup.InverseDepth = new(Vector256.ConditionalSelect(isSliver, stretchedInverseDepth, inverseDepth),
            Vector256.AndNot(slopeRight, isSliver), Vector256.AndNot(slopeUp, isSliver));
        setup.Pixel = Whole(bottom * Vector256.Create((float)TilePixels.Stride) + left);
        setup.Across = Whole(across);
        setup.Upwards = Whole(upwards);
        setup.Slack = Vector256.AndNot(inverseDepthSlack, isSliver);
        setup.MinInverseDepth = minInverseDepth * Vector256.Create(1 - 4e-6f);
        setup.MaxInverseDepth =
            shows & (Vector256.ConditionalSelect(isSliver, stretchedInverseDepth, maxInverseDepth) * Vector256.Create(1 + 4e-6f));
        // margins.md, 2: the orientation of a sliver is not known.
        setup.Outside = Vector256.ConditionalSelect(isSliver, Vector256.Create(-3f) * slack, -slack);
        setup.Inside = Vector256.ConditionalSelect(counts, slack, Vector256.Create(float.PositiveInfinity));
        return shows.ExtractMostSignificantBits();
    }

    /// <summary>The greatest inverse depth that the formula may find for triangles with next to no area; float.MaxValue if it may be any.</summary>
    /// <param name="maxInverseDepth">The greatest inverse depth of the corners.</param>
    /// <param name="size">The boxes' widths and heights together.</param>
    /// <remarks>margins.md, 2 derives the stretch.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> StretchedInverseDepth(Vector256<float> maxInverseDepth, Vector256<float> size, ScreenSpace screen)
    {
        var one = Vector256<float>.One;
        var stretch = size * Vector256.Create((float)(4 / screen.Scale));
        return Vector256.ConditionalSelect(Vector256.LessThan(stretch, one), maxInverseDepth * (one + stretch), Vector256.Create(float.MaxValue));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Reaches(Vector256<float> f, Vector256<float> right, Vector256<float> up,
        Vector256<float> across, Vector256<float> upwards, Vector256<float> slack)
    {
        var most = f + Lanes.MaxOrLast(right, Vector256<float>.Zero) * across + Lanes.MaxOrLast(up, Vector256<float>.Zero) * upwards;
        return Vector256.GreaterThanOrEqual(most, Vector256.Create(-4f) * slack);
    }

    /// <summary>Only lanes that show are used: their numbers are small and not NaN, which is an integer of its own on each processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<int> Whole(Vector256<float> numbers) => Vector256.ConvertToInt32Native(numbers);
}

/// <summary>Functions of the place in a box, one for each of eight triangles.</summary>
/// <param name="start">The values at the box's lower left sample.</param>
/// <param name="right">The steps to the next sample to the right.</param>
/// <param name="up">The steps to the next sample upwards.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct EightFunctions(Vector256<float> start, Vector256<float> right, Vector256<float> up)
{
    public readonly Vector256<float> Start = start, Right = right, Up = up;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> At(Vector256<float> x, Vector256<float> y) =>
        Vector256.MultiplyAddEstimate(y, Up, Vector256.MultiplyAddEstimate(x, Right, Start));

    /// <summary>One triangle's values along the box's lowest row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> InLowestRow(int lane, Vector512<float> x) => Lanes.Broadcast(Start, lane) + x * Lanes.Broadcast(Right, lane);
}
