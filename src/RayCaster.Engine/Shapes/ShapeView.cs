namespace RayCaster.Engine;

/// <summary>What views of all kinds of shape share; only a shape's formula is compiled for each kind.</summary>
internal abstract class ShapeView<N>(Bounds? bounds, Camera camera) : ModelView where N : struct, IPacket<N>
{
    private readonly ClipRange clip = camera.ClipRange;

    public sealed override PixelRect ShowsIn { get; } =
        bounds is { } known ? new ScreenBounds(camera).TileOf(known) : PixelRect.Everywhere;

    public sealed override bool IsShape => true;

    public sealed override HitRangePacket Narrow(RegionPacket parts, HitRange whole)
    {
        Intersect(parts, out var crossings);
        var nearCounts = clip.CountsMask(crossings.Near, parts.DepthPerT);
        var hit = clip.First(crossings, parts.DepthPerT, nearCounts);
        return new(
            // a hit that counts is not behind the camera
            WidePacket.Select(hit.IsAlwaysNaN, double.PositiveInfinity, WidePacket.MaxNative(hit.Lo, hit.Gap)),
            WidePacket.Select(hit.MayBeNaN, double.PositiveInfinity, hit.Hi),
            nearCounts.Lo);
    }

    public sealed override void Intersect(RayStream rays, int index)
    {
        Intersect(rays);
        rays.MergeStored<N>(index);
    }

    /// <summary>Finds where the rays of some parts may cross the shape.</summary>
    protected abstract void Intersect(RegionPacket parts, out Crossings<Interval> crossings);

    /// <summary>Stores where the rays of a stream cross the shape.</summary>
    protected abstract void Intersect(RayStream rays);
}
