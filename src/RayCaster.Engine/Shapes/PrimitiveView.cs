namespace RayCaster.Engine;

/// <summary>A primitive: its own formula over intervals tells what a tile may hit, and over packets what each pixel hits.</summary>
internal sealed class PrimitiveView<P, N>(P primitive, Bounds? bounds, Camera camera) : ShapeView<N>(bounds, camera)
    where P : struct, IPrimitive where N : struct, IPacket<N>
{
    public override bool Accept(IShapeVisitor visitor) => visitor.Visit(primitive);

    protected override void Intersect(RegionPacket parts, out Crossings<Interval> crossings) => crossings = primitive.Intersect(parts.Rays);

    // optimised from the first call: many pictures are finished before the runtime would optimise it
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    protected override void Intersect(RayStream rays)
    {
        var shape = primitive; // a local, so that its constants stay in registers; and after a formula the JIT inlines no property any more
        for (int i = 0, end = rays.Length; i < end; i += N.Count) rays.StoreCrossings(i, shape.Intersect(rays.RaysAt<N>(i)));
    }
}
