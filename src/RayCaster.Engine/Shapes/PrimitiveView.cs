namespace RayCaster.Engine;

/// <summary>A primitive: its own formula over intervals finds what a tile may hit, and over packets what each pixel hits.</summary>
internal sealed class PrimitiveView<P, N>(P primitive, Camera camera) : ShapeView<N>((primitive as IBounded)?.Bounds, camera), ICoveringView
    where P : struct, IPrimitive where N : struct, IPacket<N>
{
    public bool Accept(IShapeVisitor visitor) => visitor.Visit(primitive);

    protected override void Intersect(EightParts parts, out Crossings<Interval> crossings) => crossings = primitive.Intersect(parts.Rays);

    // many pictures are done before the runtime optimises by itself
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    protected override void Intersect(RayStream rays, int first, int end)
    {
        var shape = primitive; // a local, so that its constants stay in registers
        for (var i = first; i < end; i += N.Count) rays.Note(i, shape.Intersect(rays.RaysAt<N>(i)));
    }
}
