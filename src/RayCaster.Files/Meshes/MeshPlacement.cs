namespace RayCaster.Files;

/// <summary>Where a scene puts a mesh: a vertex p becomes Rz·Ry·Rx·(scale ∘ p) + translate.</summary>
/// <param name="Scale">A factor for each axis, none of them 0; negative mirrors.</param>
/// <param name="Rotate">Right-handed turns about the x, y and z axis, in degrees, in this order.</param>
internal readonly record struct MeshPlacement(Vector3 Scale, Vector3 Rotate, Vector3 Translate)
{
    /// <summary>The largest coordinate or radius in a scene, in absolute value: products of a few larger ones are beyond the largest
    /// double.</summary>
    internal const double MaxCoordinate = 1e100;

    /// <summary>The least size of a mesh that has one: products of a few smaller numbers are 0.</summary>
    private const double MinSize = 1e-100;

    /// <summary>The mesh as a model, without the triangles that have no area where they are placed.</summary>
    /// <param name="data">
    /// The file's vertices and triangles. The model shares the array of vertices if none is moved, and the array of indices if no triangle is
    /// dropped.
    /// </param>
    public Mesh Place(MeshData data, out int dropped)
    {
        var vertices = IsNone ? data.Vertices : PlaceVertices(data.Vertices);
        ThrowIfTooFarOrSmall(vertices);
        var indices = WithoutFlat(data.Indices, vertices);
        dropped = (data.Indices.Length - indices.Length) / 3;
        return new Mesh(vertices, indices);
    }

    private bool IsNone => Scale == new Vector3(1, 1, 1) && Rotate == Vector3.Zero && Translate == Vector3.Zero;

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // called once, for many vertices
    private Vector3[] PlaceVertices(Vector3[] from)
    {
        var (scale, translate) = (Scale, Translate);
        var (sx, cx) = SinCos(Rotate.X);
        var (sy, cy) = SinCos(Rotate.Y);
        var (sz, cz) = SinCos(Rotate.Z);
        var placed = GC.AllocateUninitializedArray<Vector3>(from.Length);
        for (var i = 0; i < from.Length; i++)
        {
            var p = from[i];
            p = new(scale.X * p.X, scale.Y * p.Y, scale.Z * p.Z);
            p = new(p.X, cx * p.Y - sx * p.Z, sx * p.Y + cx * p.Z);
            p = new(cy * p.X + sy * p.Z, p.Y, cy * p.Z - sy * p.X);
            p = new(cz * p.X - sz * p.Y, sz * p.X + cz * p.Y, p.Z);
            placed[i] = p + translate;
        }
        return placed;
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void ThrowIfTooFarOrSmall(Vector3[] vertices)
    {
        var size = 0.0;
        for (var i = 0; i < vertices.Length; i++)
        {
            ref readonly var p = ref vertices[i];
            if (!(Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))) <= MaxCoordinate)) // also NaN
                throw new OverflowException($"vertex {i + 1} is placed at {p}, but coordinates may be from -1e100 to 1e100");
            var d = p - vertices[0];
            size = Math.Max(size, Math.Max(Math.Abs(d.X), Math.Max(Math.Abs(d.Y), Math.Abs(d.Z))));
        }
        if (size is > 0 and < MinSize) throw new OverflowException($"the mesh is placed with a size of {size:R}, but the least size is 1e-100");
    }

    /// <summary>The triangles that have an area: the same array where all have.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static int[] WithoutFlat(int[] indices, Vector3[] vertices)
    {
        List<int>? kept = null;
        for (var i = 0; i < indices.Length; i += 3)
        {
            if (IsOnOneLine(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]])) kept ??= [.. indices[..i]];
            else kept?.AddRange(indices.AsSpan(i, 3));
        }
        return kept?.ToArray() ?? indices;
    }

    /// <summary>
    /// Whether three points span no area: |e1 × e2| ≤ 1e-12 · (longest side)². This limit is relative, so the unit of length does not matter.
    /// </summary>
    internal static bool IsOnOneLine(Vector3 a, Vector3 b, Vector3 c)
    {
        var longest = Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));
        return ((b - a) % (c - a)).Length <= 1e-12 * longest * longest;
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
