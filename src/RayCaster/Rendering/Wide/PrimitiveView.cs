using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>A primitive: its own formula over intervals tells what a tile may hit, and over packets what each pixel hits.</summary>
/// <typeparam name="P">The kind of shape.</typeparam>
internal sealed class PrimitiveView<P> : ModelView, ICoveringView where P : struct, IPrimitive
{
    private readonly P primitive;
    private readonly ClipRange clip;

    public PrimitiveView(P primitive, Camera camera)
    {
        (this.primitive, clip) = (primitive, camera.ClipRange);
        Extent = Tile.Everywhere;
        if (primitive is not IBounded bounded) return;
        var bounds = bounded.Bounds.PaddedFrom(camera.Position);
        (Extent, Nearest) = (Tile.Of(bounds, camera), bounds.LeastT);
    }

    /// <inheritdoc/>
    public override Tile Extent { get; }

    /// <inheritdoc/>
    public override double Nearest { get; }

    /// <inheritdoc/>
    public override Reaches Narrow(FourParts parts, Reach whole)
    {
        var crossings = primitive.Cross(parts.Rays);
        var nearCounts = clip.Counts(crossings.Near, parts.ZPerT);
        var hit = clip.First(crossings, parts.ZPerT, nearCounts);
        return new(
            Packet.Select(hit.IsNothing, double.PositiveInfinity, hit.Lo),
            Packet.Select(hit.IsNothing | hit.MayBeNaN, double.PositiveInfinity, hit.Hi),
            nearCounts.Lo);
    }

    /// <inheritdoc/>
    public override void Meet(RaySpan span, int index)
    {
        var (first, end) = (0, span.Length);
        if (Extent.IsSmall && span.Rows == 1) // its extent spares most of the span, at a cost that a large model would not win back
        {
            first = Math.Max(0, Extent.Column - span.Column);
            end = Math.Min(end, Extent.EndColumn - span.Column);
        }
        if (Vector512.IsHardwareAccelerated) Meet<WidePacket>(span, first / WidePacket.Count * WidePacket.Count, end, index);
        else Meet<Packet>(span, first / Packet.Count * Packet.Count, end, index);
    }

    /// <inheritdoc/>
    public void Hit(CoveredPart covered, double[] t, int first, int step)
    {
        if (Vector512.IsHardwareAccelerated) covered.Hit<WidePacket, P>(primitive, t, first, step);
        else covered.Hit<Packet, P>(primitive, t, first, step);
    }

    /// <inheritdoc/>
    public bool Paint(CoveredPart covered, int index, byte[] rgb, int first, int step) =>
        covered.Painter.Paint(covered.Part, covered.IsNear, primitive, this, index, rgb, first, step);

    private void Meet<N>(RaySpan span, int first, int end, int index) where N : struct, IPacket<N>
    {
        if (Nearest > 0 && span.Hides<N>(first, end, Nearest)) return;
        Cross<N>(span, first, end);
        span.KeepNoted<N>(first, end, index);
    }

    /// <summary>Only the formula is compiled for each kind of shape; what is done with its result is the span's.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)] // a picture is often drawn before the runtime would optimise by itself
    private void Cross<N>(RaySpan span, int first, int end) where N : struct, IPacket<N>
    {
        var shape = primitive; // a local, so that its constants stay in registers
        for (var i = first; i < end; i += N.Count) span.Note(i, shape.Cross(span.RaysAt<N>(i)));
    }
}
