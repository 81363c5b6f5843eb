namespace RayCaster.Engine;

/// <summary>Finds where the rays of a part hit the one shape that covers it; each thread has its own. Only t is stored.</summary>
internal sealed class CoveredHits<N>(Camera camera) : IShapeVisitor where N : struct, IPacket<N>
{
    private readonly ColumnDirections columns = new(camera, Tile.MaxStrip);
    private PixelRect part;
    private bool isFirstCrossing;
    private double[] t = [];
    private int first, step;

    /// <summary>Writes where the rays hit; returns false for a part that is narrower than a packet.</summary>
    /// <param name="t">Room for the ray parameters.</param>
    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    public bool Write(in CoveredTile covered, double[] t, int first, int step)
    {
        if (covered.Part.Width < N.Count) return false;
        (part, isFirstCrossing) = (covered.Part, covered.IsFirstCrossing);
        (this.t, this.first, this.step) = (t, first, step);
        return covered.View.Accept(this);
    }

    // optimised from the first call: many pictures are finished before the runtime would optimise it
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    public bool Visit<P>(P shape) where P : struct, IPrimitive
    {
        columns.Begin<N>(part.Column, part.Width);
        Vector3<N> origin = camera.Position;
        var (t, to, isFirstCrossing) = (this.t, first, this.isFirstCrossing); // a local stays in a register
        var (width, end) = (part.Width, part.EndRow);
        for (var row = part.Row; row < end; row++, to += step)
        {
            var upwards = camera.Upwards(Lanes.Broadcast<N>(row));
            for (var next = 0; next < width; next += N.Count)
            {
                // the last packet may overlap the one before: a call for the rest would spill the loop's registers
                var i = Math.Min(next, width - N.Count);
                var direction = camera.Direction(columns.At<N>(i), upwards);
                var crossings = shape.Intersect(new Ray<N>(origin, direction));
                var hit = isFirstCrossing ? crossings.Near : camera.ClipRange.First(crossings, camera.DepthPerT(direction));
                hit.Store(t, to + i);
            }
        }
        return true;
    }
}
