namespace RayCaster.Engine;

/// <summary>What the filter needs of eight triangles in a tile: the box of samples, an edge function for each side that is positive inside, and w as
/// a function of the place, all with margins. Each field has eight lanes.</summary>
internal static class TriangleSetUp
{
    /// <summary>The functions: the value at the box's lower left sample, the step to the right, and the step upwards.</summary>
    public const int U = 0, V = 3, W = 6, Depth = 9;

    /// <summary>Integers: the position of that sample's pixel (<see cref="TilePixels.Stride"/>), and the number of further samples to the right and
    /// upwards.</summary>
    public const int Pixel = 12, Across = 13, Upwards = 14;

    /// <summary>The error of w, and its range; the greatest w is 0 where the triangle does not show.</summary>
    public const int Slack = 15, LeastW = 16, MostW = 17;

    /// <summary>A sample with an edge function below the first is certainly outside; with all above the second it is certainly covered.</summary>
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
        left = Vector256.MaxNative(Vector256.Ceiling(left - margin), zero);
        right = Vector256.MinNative(Vector256.Floor(right + margin), Vector256.Create(tile.Width - 1f));
        bottom = Vector256.MaxNative(Vector256.Ceiling(bottom - margin), zero);
        top = Vector256.MinNative(Vector256.Floor(top + margin), Vector256.Create(tile.Height - 1f));
        var shows = Vector256.LessThanOrEqual(left, right) & Vector256.LessThanOrEqual(bottom, top);

        // Twice the areas of the triangles that a sample makes with the sides: (b − s) × (c − s). With corners off by δ such a product is off by 2 δ
        // · size, since a sample in the box is not farther from a corner than the box is wide and high. It, and its steps to the right and upwards,
        // round seven times by 2⁻²⁴ · size times how far a sample may be from a corner, and of that δ holds 2 · 2⁻²⁴ (ScreenSpace.Margin): less than
        // 4 δ · size.
        var area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        var sign = Vector256.ConditionalSelect(Vector256.LessThan(area, zero), -one, one);
        area *= sign;
        var (uRight, uUp) = ((by - cy) * sign, (cx - bx) * sign);
        var (vRight, vUp) = ((cy - ay) * sign, (ax - cx) * sign);
        var (wRight, wUp) = ((ay - by) * sign, (bx - ax) * sign);
        var u = (left - bx) * uRight + (bottom - by) * uUp;
        var v = (left - cx) * vRight + (bottom - cy) * vUp;
        var w = (left - ax) * wRight + (bottom - ay) * wUp;
        var slack = Vector256.Create(6f) * margin * size;

        // The whole box, cut by the tile, may lie outside of one edge.
        var (across, upwards) = (right - left, top - bottom);
        shows &= Reaches(u, uRight, uUp, across, upwards, slack) & Reaches(v, vRight, vUp, across, upwards, slack)
            & Reaches(w, wRight, wUp, across, upwards, slack);

        // A triangle with next to no area (LeastWidth) has no side functions to speak of, and the formula may put its t anywhere that its corners
        // span along the axis that the ray follows most. Of a corner s pixels beside the ray that is its depth stretched by at most √3 s / scale.
        var (mostW, leastW) = (Lanes.Most(t.A.W, t.B.W, t.C.W), Lanes.Least(t.A.W, t.B.W, t.C.W));
        var ratio = mostW / leastW;
        var isSliver = ~Vector256.GreaterThan(area, size * Vector256.Create(screen.LeastWidth) * ratio * ratio);
        var stretchedW = StretchedW(mostW, size, screen);

        var depthRight = ((t.B.W - t.A.W) * vRight + (t.C.W - t.A.W) * wRight) / area;
        var depthUp = ((t.B.W - t.A.W) * vUp + (t.C.W - t.A.W) * wUp) / area;
        var depth = t.A.W + (left - ax) * depthRight + (bottom - ay) * depthUp;
        // Corners off by δ move the plane of w by its slope · δ; the slope itself is rounded by the area's 2⁻²⁴ size² / area; w by 2⁻²⁴ of itself.
        var slope = Vector256.Abs(depthRight) + Vector256.Abs(depthUp);
        var depthSlack = Vector256.Create(4f) * slope * (margin + rounding * size * (one + size * size / area)) +
            Vector256.Create(4f) * rounding * mostW;

        var counts = Vector256.LessThanOrEqual(mostW, Vector256.Create(screen.MostSureW))
            & Vector256.GreaterThanOrEqual(leastW, Vector256.Create(screen.LeastSureW)) & ~isSliver;

        Keep(fields, U, u, uRight, uUp);
        Keep(fields, V, v, vRight, vUp);
        Keep(fields, W, w, wRight, wUp);
        Keep(fields, Depth, Vector256.ConditionalSelect(isSliver, stretchedW, depth),
            Vector256.AndNot(depthRight, isSliver), Vector256.AndNot(depthUp, isSliver));
        Keep(fields, Pixel, Whole(bottom * Vector256.Create((float)TilePixels.Stride) + left), Whole(across), Whole(upwards));
        Keep(fields, Slack, Vector256.AndNot(depthSlack, isSliver), leastW * Vector256.Create(1 - 4e-6f),
            shows & (Vector256.ConditionalSelect(isSliver, stretchedW, mostW) * Vector256.Create(1 + 4e-6f)));
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
        var (u, v, w) = (bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx);
        var slack = Vector256.Create(6f) * margin * size;
        return Vector256.LessThan(Lanes.Least(u, v, w), -slack) & Vector256.GreaterThan(Lanes.Most(u, v, w), slack);
    }

    /// <summary>The greatest w that the formula may find for triangles with next to no area; float.MaxValue if it may be any.</summary>
    /// <param name="mostW">The greatest w of the corners.</param>
    /// <param name="size">The boxes' widths and heights together; <see cref="Of"/> derives the stretch.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> StretchedW(Vector256<float> mostW, Vector256<float> size, ScreenSpace screen)
    {
        var (one, stretch) = (Vector256<float>.One, size * Vector256.Create((float)(4 / screen.Scale)));
        return Vector256.ConditionalSelect(Vector256.LessThan(stretch, one), mostW * (one + stretch), Vector256.Create(float.MaxValue));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Reaches(Vector256<float> f, Vector256<float> right, Vector256<float> up,
        Vector256<float> across, Vector256<float> upwards, Vector256<float> slack)
    {
        var most = f + Vector256.MaxNative(right, Vector256<float>.Zero) * across + Vector256.MaxNative(up, Vector256<float>.Zero) * upwards;
        return Vector256.GreaterThanOrEqual(most, Vector256.Create(-4f) * slack);
    }

    /// <summary>An integer of one triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Whole(RawSpan<float> setup, int lane, int field) => BitConverter.SingleToInt32Bits(setup[8 * field + lane]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Whole(Vector256<float> numbers) => Vector256.ConvertToInt32Native(numbers).AsSingle();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Keep(float[] fields, int first, Vector256<float> a, Vector256<float> b, Vector256<float> c)
    {
        a.StoreTo(fields, 8 * first);
        b.StoreTo(fields, 8 * first + 8);
        c.StoreTo(fields, 8 * first + 16);
    }
}
