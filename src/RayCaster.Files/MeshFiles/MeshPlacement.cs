namespace RayCaster.Files;

/// <summary>Where a scene puts a mesh: a vertex p becomes Rz·Ry·Rx·(scale ∘ p) + translate.</summary>
/// <param name="Scale">A factor for each axis, none of them 0; negative mirrors.</param>
/// <param name="Rotate">Right-handed turns about the x, y and z axis, in degrees, in this order.</param>
public readonly record struct MeshPlacement(Vector3 Scale, Vector3 Rotate, Vector3 Translate)
{
    /// <summary>The largest coordinate or radius in a scene, in absolute value: products of a few larger ones are beyond the largest
    /// double.</summary>
    internal const double MaxCoordinate = 1e100;

    /// <summary>The mesh as a model, without the triangles that have no area where they are placed.</summary>
    /// <param name="data">
    /// The file's vertices and triangles. The model shares the array of vertices if none is moved, and the array of indices if no triangle is
    /// dropped.
    /// </param>
    /// <param name="threads">How many threads place a large mesh; one per core if left out.</param>
    /// <exception cref="OverflowException">A placed vertex is farther than 1e100 from the origin.</exception>
    public Mesh Place(MeshData data, out int dropped, int? threads = null)
    {
        var threadCount = threads ?? Environment.ProcessorCount;
        var vertices = IsNone ? data.Vertices : PlaceVertices(data.Vertices, threadCount);
        ThrowIfTooFar(vertices, threadCount);
        var indices = WithoutFlat(data.Indices, vertices, threadCount);
        dropped = (data.Indices.Length - indices.Length) / 3;
        return new Mesh(vertices, indices);
    }

    private bool IsNone => Scale == new Vector3(1, 1, 1) && Rotate == Vector3.Zero && Translate == Vector3.Zero;

    private Vector3[] PlaceVertices(Vector3[] from, int threads)
    {
        var placement = this;
        var placed = GC.AllocateUninitializedArray<Vector3>(from.Length);
        Ranges.Each(from.Length, threads, (start, length) => placement.Place(from.AsSpan(start, length), placed.AsSpan(start, length)));
        return placed;
    }

    private static void ThrowIfTooFar(Vector3[] vertices, int threads)
    {
        var areNear = true;
        Ranges.Each(vertices.Length, threads, (start, length) =>
        {
            if (!(Largest(vertices.AsSpan(start, length)) <= MaxCoordinate)) Volatile.Write(ref areNear, false);
        });
        if (areNear) return;
        var first = Array.FindIndex(vertices, p => !(Largest([p]) <= MaxCoordinate));
        throw new OverflowException($"vertex {first + 1} is placed at {vertices[first]}, but coordinates may be from -1e100 to 1e100");
    }

    /// <summary>The largest coordinate, in absolute value; NaN if one is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static double Largest(ReadOnlySpan<Vector3> vertices)
    {
        var largest = 0d;
        foreach (ref readonly var p in vertices)
            largest = Math.Max(largest, Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
        return largest;
    }

    /// <summary>Places some vertices.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // called a few times, for many vertices each
    private void Place(ReadOnlySpan<Vector3> from, Span<Vector3> placed)
    {
        var (scale, translate) = (Scale, Translate);
        var (sx, cx) = SinCos(Rotate.X);
        var (sy, cy) = SinCos(Rotate.Y);
        var (sz, cz) = SinCos(Rotate.Z);
        for (var i = 0; i < from.Length; i++)
        {
            var p = from[i];
            p = new(scale.X * p.X, scale.Y * p.Y, scale.Z * p.Z);
            p = new(p.X, cx * p.Y - sx * p.Z, sx * p.Y + cx * p.Z);
            p = new(cy * p.X + sy * p.Z, p.Y, cy * p.Z - sy * p.X);
            p = new(cz * p.X - sz * p.Y, sz * p.X + cz * p.Y, p.Z);
            placed[i] = p + translate;
        }
    }

    /// <summary>The triangles that have an area: the same array where all have.</summary>
    private static int[] WithoutFlat(int[] indices, Vector3[] vertices, int threads)
    {
        var flat = 0;
        Ranges.Each(indices.Length, threads, (start, length) => Interlocked.Add(ref flat, CountFlat(indices.AsSpan(start, length), vertices)));
        return flat == 0 ? indices : WithoutFlat(indices, vertices, new int[indices.Length - 3 * flat]);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static int[] WithoutFlat(ReadOnlySpan<int> indices, Vector3[] vertices, int[] kept)
    {
        for (var to = 0; !indices.IsEmpty; indices = indices[3..])
        {
            if (IsFlat(vertices[indices[0]], vertices[indices[1]], vertices[indices[2]])) continue;
            indices[..3].CopyTo(kept.AsSpan(to));
            to += 3;
        }
        return kept;
    }

    /// <remarks>The corners of many triangles are copied first: they may lie anywhere, and so the processor waits for all of them at once.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static int CountFlat(ReadOnlySpan<int> indices, Vector3[] vertices)
    {
        const int AtOnce = 3 * 32;
        Span<Vector3> corners = stackalloc Vector3[AtOnce];
        var count = 0;
        for (; !indices.IsEmpty; indices = indices[Math.Min(AtOnce, indices.Length)..])
        {
            if (indices.Length < AtOnce) corners = corners[..indices.Length];
            for (var i = 0; i < corners.Length; i++) corners[i] = vertices[indices[i]];
            for (var i = 0; i < corners.Length; i += 3)
                if (IsFlat(corners[i], corners[i + 1], corners[i + 2]))
                    count++;
        }
        return count;
    }

    /// <remarks>
    /// Almost all triangles pass a test without roots: squared, and with twice the limit of <see cref="Triangle.IsOnOneLine"/>. A triangle that
    /// passes it has an area by that definition too, because the roots round by only a few parts in 10¹⁶. The bounds 1e-100 and 1e100 keep all
    /// products within a double.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsFlat(Vector3 a, Vector3 b, Vector3 c)
    {
        var (e1, e2, e3) = (b - a, c - a, c - b);
        var (n, longest) = (e1 % e2, Math.Max(e1 * e1, Math.Max(e2 * e2, e3 * e3)));
        return !(longest is > 1e-100 and < 1e100 && n * n > 4e-24 * longest * longest) && Triangle.IsOnOneLine(a, b, c);
    }

    /// <summary>
    /// Sine and cosine of an angle in degrees, exact for quarter turns, so that a box turned by 90° keeps straight sides.
    /// </summary>
    private static (double Sin, double Cos) SinCos(double degrees) => Math.IEEERemainder(degrees, 360) switch
    {
        0 => (0, 1),
        90 => (1, 0),
        -90 => (-1, 0),
        180 or -180 => (0, -1),
        var angle => Math.SinCos(angle * Math.PI / 180),
    };
}
