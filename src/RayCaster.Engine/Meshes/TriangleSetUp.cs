namespace RayCaster.Engine;

/// <summary>What the filter needs of eight triangles in a tile: the box of samples, an edge function for each side that is positive inside, and
/// inverse depth as a function of the place, all with margins. Each field has eight lanes.</summary>
internal static class TriangleSetUp
{
    /// <summary>The functions: the value at the box's lower left sample, the step to the right, and the step upwards.</summary>
    public const int E0 = 0, E1 = 3, E2 = 6, InverseDepth = 9;

    /// <summary>Integers: the position of that sample's pixel (<see cref="TilePixels.Stride"/>), and the number of further samples to the right and
    /// upwards.</summary>
    public const int Pixel = 12, Across = 13, Upwards = 14;

    /// <summary>The error of inverse depth, and its range; the greatest inverse depth is 0 where the triangle does not show.</summary>
    public const int Slack = 15, MinInverseDepth = 16, MaxInverseDepth = 17;

    /// <summary>A sample with an edge function below the first is certainly outside; with all above the second it is certainly
    /// covered.</summary>
    public const int Outside = 18, Inside = 19;

    /// <summary>Numbers in all.</summary>
    public const int Length = 8 * 20;

    /// <summary>Computes the fields of eight triangles and returns a bit for each that may show in the tile.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public static uint Of(TriangleQueue triangles, int first, ScreenSpace screen, in Tile tile, float[] fields)
    {
        var t = triangles.Load(first);
        Vector256<float> zero = Vector256<float>.Zero, one = Vector256<float>.One;
        var margin = Vector256.Create(screen.Margin);
        var rounding = Vector256.Create(screen.Roundings);
        var (column, row) = (Vector256.Create((float)tile.Column), Vector256.Create((float)tile.Row));
        var (ax, bx, cx) = (t.A.X - column, t.B.X - column, t.C.X - column);
        var (ay, by, cy) = (t.A.Y - row, t.B.Y - row, t.C.Y - row);
        var (left, right) = (Lanes.Least(ax, bx, cx), Lanes.Most(ax, bx, cx));
        var (bottom, top) = (Lanes.Least(ay, by, cy), Lanes.Most(ay, by, cy));
        var size = right - left + (top - bottom);
        left = Lanes.Greater(Vector256.Ceiling(left - margin), zero);
        right = Lanes.Lesser(Vector256.Floor(right + margin), Vector256.Create(tile.Width - 1f));
        bottom = Lanes.Greater(Vector256.Ceiling(bottom - margin), zero);
        top = Lanes.Lesser(Vector256.Floor(top + margin), Vector256.Create(tile.Height - 1f));
        var shows = Vector256.LessThanOrEqual(left, right) & Vector256.LessThanOrEqual(bottom, top);

        // Twice the areas of the triangles that a sample makes with the sides: (b − s) × (c − s). With corners off by δ such a product is off by 2 δ
        // · size, since a sample in the box is not farther from a corner than the box is wide and high. It, and its steps to the right and upwards,
        // round seven times by 2⁻²⁴ · size times how far a sample may be from a corner, and of that δ holds 2 · 2⁻²⁴ (ScreenSpace.Margin): less than
        // 4 δ · size.
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

        // A triangle with next to no area (MinWidth) has no side functions to speak of, and the formula may put its t anywhere that its corners
        // span along the axis that the ray follows most. Of a corner s pixels beside the ray that is its depth stretched by at most √3 s / scale.
        var (maxInverseDepth, minInverseDepth) = (t.MaxInverseDepth, t.MinInverseDepth);
        var ratio = maxInverseDepth / minInverseDepth;
        var isSliver = ~Vector256.GreaterThan(area, size * Vector256.Create(screen.MinWidth) * ratio * ratio);
        var stretchedInverseDepth = StretchedInverseDepth(maxInverseDepth, size, screen);

        var slopeRight = ((t.B.InverseDepth - t.A.InverseDepth) * e1Right + (t.C.InverseDepth - t.A.InverseDepth) * e2Right) / area;
        var slopeUp = ((t.B.InverseDepth - t.A.InverseDepth) * e1Up + (t.C.InverseDepth - t.A.InverseDepth) * e2Up) / area;
        var inverseDepth = t.A.InverseDepth + (left - ax) * slopeRight + (bottom - ay) * slopeUp;
        // Corners off by δ move the plane of inverse depth by its slope · δ; the slope itself is rounded by the area's 2⁻²⁴ size² / area; inverse
        // depth by 2⁻²⁴ of itself.
        var slope = Vector256.Abs(slopeRight) + Vector256.Abs(slopeUp);
        var inverseDepthSlack = Vector256.Create(4f) * slope * (margin + rounding * size * (one + size * size / area)) +
            Vector256.Create(4f) * rounding * maxInverseDepth;

        var counts = Vector256.LessThanOrEqual(maxInverseDepth, Vector256.Create(screen.MaxSureInverseDepth))
            & Vector256.GreaterThanOrEqual(minInverseDepth, Vector256.Create(screen.MinSureInverseDepth)) & ~isSliver;

        Store(fields, E0, e0, e0Right, e0Up);
        Store(fields, E1, e1, e1Right, e1Up);
        Store(fields, E2, e2, e2Right, e2Up);
        Store(fields, InverseDepth, Vector256.ConditionalSelect(isSliver, stretchedInverseDepth, inverseDepth),
            Vector256.AndNot(slopeRight, isSliver), Vector256.AndNot(slopeUp, isSliver));
        Store(fields, Pixel, Whole(bottom * Vector256.Create((float)TilePixels.Stride) + left), Whole(across), Whole(upwards));
        Store(fields, Slack, Vector256.AndNot(inverseDepthSlack, isSliver), minInverseDepth * Vector256.Create(1 - 4e-6f),
            shows & (Vector256.ConditionalSelect(isSliver, stretchedInverseDepth, maxInverseDepth) * Vector256.Create(1 + 4e-6f)));
        // The orientation of a sliver is not known; if it is the other one, its functions are at most the slack of its area and of the others.
        Vector256.ConditionalSelect(isSliver, Vector256.Create(-3f) * slack, -slack).StoreTo(fields, 8 * Outside);
        Vector256.ConditionalSelect(counts, slack, Vector256.Create(float.PositiveInfinity)).StoreTo(fields, 8 * Inside);
        return shows.ExtractMostSignificantBits();
    }

    /// <summary>Where a sample in a triangle's box is certainly outside the triangle.</summary>
    /// <param name="size">The boxes' widths and heights together.</param>
    /// <param name="margin">How far off the corners may be.</param>
    /// <remarks><see cref="Of"/> derives the error of the areas. The orientation of a sliver is not known, so one area must certainly be below 0,
    /// and one above.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> IsOutside(in EightTriangles t, Vector256<float> column, Vector256<float> row, Vector256<float> size,
        Vector256<float> margin)
    {
        var (ax, bx, cx) = (t.A.X - column, t.B.X - column, t.C.X - column);
        var (ay, by, cy) = (t.A.Y - row, t.B.Y - row, t.C.Y - row);
        var (e0, e1, e2) = (bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx);
        var slack = Vector256.Create(6f) * margin * size;
        return Vector256.LessThan(Lanes.Least(e0, e1, e2), -slack) & Vector256.GreaterThan(Lanes.Most(e0, e1, e2), slack);
    }

    /// <summary>The greatest inverse depth that the formula may find for triangles with next to no area; float.MaxValue if it may be any.</summary>
    /// <param name="maxInverseDepth">The greatest inverse depth of the corners.</param>
    /// <param name="size">The boxes' widths and heights together; <see cref="Of"/> derives the stretch.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> StretchedInverseDepth(Vector256<float> maxInverseDepth, Vector256<float> size, ScreenSpace screen)
    {
        var (one, stretch) = (Vector256<float>.One, size * Vector256.Create((float)(4 / screen.Scale)));
        return Vector256.ConditionalSelect(Vector256.LessThan(stretch, one), maxInverseDepth * (one + stretch), Vector256.Create(float.MaxValue));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Reaches(Vector256<float> f, Vector256<float> right, Vector256<float> up,
        Vector256<float> across, Vector256<float> upwards, Vector256<float> slack)
    {
        var most = f + Lanes.Greater(right, Vector256<float>.Zero) * across + Lanes.Greater(up, Vector256<float>.Zero) * upwards;
        return Vector256.GreaterThanOrEqual(most, Vector256.Create(-4f) * slack);
    }

    /// <summary>An integer of one triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Whole(RawSpan<float> setup, int lane, int field) => BitConverter.SingleToInt32Bits(setup[8 * field + lane]);

    /// <summary>Only lanes that show are used: their numbers are small and not NaN, which is an integer of its own on each processor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Whole(Vector256<float> numbers) => Vector256.ConvertToInt32Native(numbers).AsSingle();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(float[] fields, int first, Vector256<float> a, Vector256<float> b, Vector256<float> c)
    {
        a.StoreTo(fields, 8 * first);
        b.StoreTo(fields, 8 * first + 8);
        c.StoreTo(fields, 8 * first + 16);
    }
}
