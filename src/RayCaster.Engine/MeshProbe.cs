namespace RayCaster.Engine;

/// <summary>A mesh for few rays: of its triangles only those whose cluster has a box that a ray may meet are intersected, by the definition's
/// formula.</summary>
internal sealed class MeshProbe(Mesh mesh, ScreenSpace screen, int threads) : Model
{
    private readonly TriangleBoxes boxes = TriangleBoxes.Of(mesh, default, threads);
    private readonly List<int> near = []; // the first of each packet of boxes of which one may be met by the rays of a square

    /// <summary>The ray of one pixel of the square; null if nothing is known of it.</summary>
    public Pyramid? Pixel { private get; set; }

    public override Bounds? Bounds => boxes.Bounds;

    /// <summary>A pixel whose ray meets one of the boxes; null if none of some is in the picture.</summary>
    public (int Column, int Row)? RandomPixel(Random random)
    {
        for (var attempt = 0; attempt < 8 && boxes.Count > 0; attempt++)
        {
            var i = random.Next(boxes.Count);
            var center = boxes.Middle + 0.5 * boxes.Extent * (Corner(boxes.Lows<Packet>(i)) + Corner(boxes.Highs<Packet>(i)));
            var seen = screen.ToCamera(center);
            var (column, row, _) = screen.Project<Scalar>(seen.X, seen.Y, seen.Z);
            var (x, y) = (column.Value, row.Value);
            if (seen.Z > 0 && x >= 0 && x < screen.Camera.Width && y >= 0 && y < screen.Camera.Height) return ((int)x, (int)y);
        }
        return null;

        static Vector3 Corner(Vector3<Packet> p) => new(p.X.Lanes[0], p.Y.Lanes[0], p.Z.Lanes[0]);
    }

    /// <summary>Sets the rays of some neighbouring pixels; returns whether they may meet a box.</summary>
    /// <param name="rays">Null if nothing is known of them.</param>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public bool SetSquare(in Pyramid? rays)
    {
        near.Clear();
        for (var first = 0; first < boxes.Count; first += Packet.Count)
            if (Near(first, rays) != 0) near.Add(first);
        return near.Count > 0;
    }

    /// <inheritdoc cref="Mesh.Intersect"/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override double? Intersect(Ray ray)
    {
        var (nearest, pixel) = (double.PositiveInfinity, Pixel);
        var along = new RaySpace<Scalar>(new Ray<Scalar>(ray.Origin, ray.Direction));
        foreach (var first in near)
        {
            for (var left = Near(first, pixel); left != 0; left &= left - 1)
            {
                var (triangle, end) = boxes.TrianglesOf(first + BitOperations.TrailingZeroCount(left));
                for (; triangle < end; triangle++)
                {
                    double t = mesh[triangle].Intersect(along).Near;
                    if (t < nearest && ray.Counts(t)) nearest = t;
                }
            }
        }
        return nearest < double.PositiveInfinity ? nearest : null;
    }

    /// <summary>A bit for each box of a packet that may be met.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint Near(int first, in Pyramid? pyramid)
    {
        var all = (1u << Math.Min(Packet.Count, boxes.Count - first)) - 1;
        if (pyramid is not { } rays) return all;
        Packet unit = boxes.Extent;
        Vector3<Packet> middle = boxes.Middle - screen.Camera.Position;
        return ~Packet.Bits(rays.IsOutside(unit * boxes.Lows<Packet>(first) + middle, unit * boxes.Highs<Packet>(first) + middle)) & all;
    }
}
