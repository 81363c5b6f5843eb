namespace RayCaster;

/// <summary>Where a scene puts a mesh: a vertex p becomes Rz·Ry·Rx·(scale ∘ p) + translate.</summary>
/// <param name="Scale">A factor for each axis, none of them 0; negative mirrors.</param>
/// <param name="Rotate">Right-handed turns about the x, y and z axis, in degrees, in this order.</param>
/// <param name="Translate">The way to go at last.</param>
public readonly record struct MeshPlacement(Vector3 Scale, Vector3 Rotate, Vector3 Translate)
{
    /// <summary>The mesh as a model, without the triangles that have no area where they are placed.</summary>
    /// <param name="data">The file's vertices and triangles.</param>
    /// <param name="dropped">How many triangles had no area.</param>
    /// <exception cref="OverflowException">A placed vertex is not finite.</exception>
    public Mesh Place(MeshData data, out int dropped)
    {
        var vertices = new Vector3[data.Vertices.Length];
        var (sx, cx) = SinCos(Rotate.X);
        var (sy, cy) = SinCos(Rotate.Y);
        var (sz, cz) = SinCos(Rotate.Z);
        for (var i = 0; i < vertices.Length; i++)
        {
            var p = data.Vertices[i];
            p = new(Scale.X * p.X, Scale.Y * p.Y, Scale.Z * p.Z);
            p = new(p.X, cx * p.Y - sx * p.Z, sx * p.Y + cx * p.Z);
            p = new(cy * p.X + sy * p.Z, p.Y, cy * p.Z - sy * p.X);
            p = new(cz * p.X - sz * p.Y, sz * p.X + cz * p.Y, p.Z);
            vertices[i] = p + Translate;
            if (!double.IsFinite(vertices[i].X) || !double.IsFinite(vertices[i].Y) || !double.IsFinite(vertices[i].Z))
                throw new OverflowException($"vertex {i + 1} is placed at {vertices[i]}, beyond the largest number");
        }

        var indices = new List<int>(data.Indices.Length);
        for (var i = 0; i < data.Indices.Length; i += 3)
        {
            var corners = data.Indices.AsSpan(i, 3);
            if (!Triangle.IsOnOneLine(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]])) indices.AddRange(corners);
        }
        dropped = (data.Indices.Length - indices.Count) / 3;
        return new Mesh(vertices, [.. indices]);
    }

    /// <summary>Sine and cosine of an angle in degrees, exact for quarter turns, so that a box turned by 90° keeps straight sides.</summary>
    private static (double Sin, double Cos) SinCos(double degrees) => Math.IEEERemainder(degrees, 360) switch
    {
        0 => (0, 1),
        90 => (1, 0),
        -90 => (-1, 0),
        180 or -180 => (0, -1),
        var angle => Math.SinCos(angle * Math.PI / 180),
    };
}
