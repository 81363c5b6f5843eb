using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>A primitive: its own formula over intervals tells what a tile may hit, and over packets what each pixel hits.</summary>
/// <typeparam name="P">The kind of shape.</typeparam>
internal sealed class PrimitiveView<P>(P primitive, Camera camera) : ShapeView((primitive as IBounded)?.Bounds, camera), ICoveringView
    where P : struct, IPrimitive
{
    /// <inheritdoc/>
    public void Hit(CoveredPart covered, double[] t, int first, int step)
    {
        if (Vector512.IsHardwareAccelerated) covered.Hit<WidePacket, P>(primitive, t, first, step);
        else covered.Hit<Packet, P>(primitive, t, first, step);
    }

    /// <inheritdoc/>
    public bool Paint(RoughPainter painter, int index, bool isNear) => painter.Paint(primitive, index, isNear);

    /// <inheritdoc/>
    protected override void Cross(EightParts parts, out Crossings<Interval> crossings) => crossings = primitive.Cross(parts.Rays);

    /// <inheritdoc/>
    protected override void Cross(RaySpan span, int first, int end)
    {
        if (Vector512.IsHardwareAccelerated) Cross<WidePacket>(span, first, end);
        else Cross<Packet>(span, first, end);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)] // a picture is often drawn before the runtime would optimise by itself
    private void Cross<N>(RaySpan span, int first, int end) where N : struct, IPacket<N>
    {
        var shape = primitive; // a local, so that its constants stay in registers
        for (var i = first; i < end; i += N.Count) span.Note(i, shape.Cross(span.RaysAt<N>(i)));
    }
}
