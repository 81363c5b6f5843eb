namespace RayCaster;

/// <summary>Where a scene puts a mesh: a vertex p becomes Rz·Ry·Rx·(scale ∘ p) + translate.</summary>
/// <param name="Scale">A factor for each axis, none of them 0; negative mirrors.</param>
/// <param name="Rotate">Right-handed turns about the x, y and z axis, in degrees, in this order.</param>
/// <param name="Translate">The way to go at last.</param>
public readonly record struct MeshPlacement(Vector3 Scale, Vector3 Rotate, Vector3 Translate)
{
    /// <summary>The mesh as a model, without the triangles that have no area where they are placed.</summary>
    /// <param name="data">The file's vertices and triangles. The model keeps the array of indices where no triangle is dropped.</param>
    /// <param name="dropped">How many triangles had no area.</param>
    /// <exception cref="OverflowException">A placed vertex is not finite.</exception>
    public Mesh Place(MeshData data, out int dropped)
    {
        var vertices = PlaceVertices(data.Vertices);
        var indices = WithoutFlat(data.Indices, vertices);
        dropped = (data.Indices.Length - indices.Length) / 3;
        return new Mesh(vertices, indices);
    }

    private Vector3[] PlaceVertices(Vector3[] from)
    {
        var (scale, translate) = (Scale, Translate);
        var (sx, cx) = SinCos(Rotate.X);
        var (sy, cy) = SinCos(Rotate.Y);
        var (sz, cz) = SinCos(Rotate.Z);
        var placed = GC.AllocateUninitializedArray<Vector3>(from.Length);
        var tooLarge = new int[Ranges.CountIn(from.Length)]; // the first of each range, counted from 1, or 0
        Ranges.Each(from.Length, Environment.ProcessorCount, (start, length) =>
        {
            for (var i = start + length - 1; i >= start; i--)
            {
                var p = from[i];
                p = new(scale.X * p.X, scale.Y * p.Y, scale.Z * p.Z);
                p = new(p.X, cx * p.Y - sx * p.Z, sx * p.Y + cx * p.Z);
                p = new(cy * p.X + sy * p.Z, p.Y, cy * p.Z - sy * p.X);
                p = new(cz * p.X - sz * p.Y, sz * p.X + cz * p.Y, p.Z);
                placed[i] = p += translate;
                if (!double.IsFinite(p.X) || !double.IsFinite(p.Y) || !double.IsFinite(p.Z)) tooLarge[start / Ranges.Usual] = i + 1;
            }
        });
        foreach (var number in tooLarge)
            if (number > 0) throw new OverflowException($"vertex {number} is placed at {placed[number - 1]}, beyond the largest number");
        return placed;
    }

    /// <summary>The triangles that have an area: the same array where all have.</summary>
    private static int[] WithoutFlat(int[] indices, Vector3[] vertices)
    {
        bool IsFlat(int i) => Triangle.IsOnOneLine(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]);

        var kept = new int[Ranges.CountIn(indices.Length) + 1]; // how many in the ranges before, when they are summed up
        Ranges.Each(indices.Length, Environment.ProcessorCount, (start, length) =>
        {
            var count = length;
            for (var i = start; i < start + length; i += 3)
                if (IsFlat(i)) count -= 3;
            kept[start / Ranges.Usual + 1] = count;
        });
        for (var range = 1; range < kept.Length; range++) kept[range] += kept[range - 1];
        if (kept[^1] == indices.Length) return indices;

        var left = GC.AllocateUninitializedArray<int>(kept[^1]);
        Ranges.Each(indices.Length, Environment.ProcessorCount, (start, length) =>
        {
            var to = kept[start / Ranges.Usual];
            if (kept[start / Ranges.Usual + 1] - to == length)
                indices.AsSpan(start, length).CopyTo(left.AsSpan(to));
            else
                for (var i = start; i < start + length; i += 3)
                {
                    if (IsFlat(i)) continue;
                    indices.AsSpan(i, 3).CopyTo(left.AsSpan(to));
                    to += 3;
                }
        });
        return left;
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
