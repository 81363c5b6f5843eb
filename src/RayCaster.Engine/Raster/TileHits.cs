namespace RayCaster.Engine;

/// <summary>Computes where the rays of a tile hit the triangles that the filter proposes, by the triangle's formula; each thread has its
/// own.</summary>
internal sealed class TileHits<N>(ScreenSpace screen, TilePixels pixels) where N : struct, IPacket<N>
{
    private readonly ExactHits<N> exact = new(screen);

    public void SetMesh(Vector3[] vertices, int[] indices) => exact.SetMesh(vertices, indices);

    public void Decide()
    {
        if (pixels.Queue.Count == 0) return;
        pixels.BeginExactT();
        foreach (var (pixel, triangle, maxInverseDepth) in pixels.Queue.Items)
            if (!(maxInverseDepth < pixels.OccluderInverseDepth[pixel]))
                Add(pixel, triangle);
        exact.Flush(pixels.ExactT, pixels.OccluderInverseDepth);
        pixels.Queue.Clear();
    }

    /// <summary>Keeps the mesh's hits for some pixels of the tile that are nearer than all before.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Intersect(RayStream rays, int index)
    {
        var (exactT, hasExactT, proposed) = (pixels.ExactT, pixels.HasExactT, pixels.Proposed);
        var first = (rays.Row - pixels.Rect.Row) * TilePixels.Stride + rays.Column - pixels.Rect.Column;
        for (var row = 0; row < rays.Rows; row++)
        {
            for (var column = 0; column < rays.Width; column += N.Count)
            {
                var (i, at) = (row * rays.Pitch + column, first + row * TilePixels.Stride + column);
                var hit = Lanes.Broadcast<N>(double.NaN);
                if (HasAny(at)) hit = rays.First(i, exact.Intersect(rays.RaysAt<N>(i), new(proposed), at));
                else if (!hasExactT) continue;
                if (hasExactT)
                {
                    var other = N.Load(exactT, at);
                    hit = N.Select(hit <= other, hit, other);
                }
                rays.MergeNearest(i, hit, Lanes.Broadcast<N>(index));
            }
        }
    }

    /// <summary>Writes the bytes of a tile in which only the mesh may show.</summary>
    public void Paint(MeshPainter painter, byte[] rgb, int first, int step)
    {
        var exactT = pixels.HasExactT ? pixels.ExactT : null;
        painter.Paint(pixels.Rect, pixels.OccluderInverseDepth, pixels.CandidateInverseDepth, exactT, rgb, first, step);
        foreach (var pixel in painter.Doubts.Items)
        {
            if (!pixels.HasExactT) pixels.ExactT[pixel] = double.PositiveInfinity;
            if (pixels.CandidateInverseDepth[pixel] > 0) Add(pixel, pixels.Proposed[pixel]);
        }
        exact.Flush(pixels.ExactT, pixels.OccluderInverseDepth);
        foreach (var pixel in painter.Doubts.Items) painter.Write(pixel, pixels.ExactT[pixel]);
    }

    private void Add(int pixel, int triangle) => exact.Add(
        pixels.Rect.Column + pixel % TilePixels.Stride, pixels.Rect.Row + pixel / TilePixels.Stride,
        triangle, pixel, pixels.ExactT, pixels.OccluderInverseDepth);

    /// <summary>Whether any pixel of a packet has a proposed triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool HasAny(int pixel) => N.Count == 8
        ? pixels.CandidateInverseDepth.Load256(pixel) != Vector256<float>.Zero
        : pixels.CandidateInverseDepth.Load128(pixel) != Vector128<float>.Zero;
}
