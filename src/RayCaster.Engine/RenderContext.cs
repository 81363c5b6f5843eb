namespace RayCaster.Engine;

/// <summary>Finds what the rays of a strip of the picture hit; each thread has its own.</summary>
/// <param name="strip">Up to eight tiles side by side; none crosses a multiple of <see cref="Tile.MaxSide"/>.</param>
internal delegate void StripCaster(in PixelRect strip, IHitConsumer consumer);

/// <summary>What all threads share that draw one picture.</summary>
internal abstract class RenderContext(Scene scene, Plan plan) : IDisposable
{
    public Scene Scene => scene;

    public Plan Plan => plan;

    public HitShader Shader => field ??= new(scene, plan.Threads);

    /// <summary>A frame for packets of the plan's width; everything else is generic over this choice.</summary>
    /// <param name="cancellation">Stops the preparation of the models with an <see cref="OperationCanceledException"/>.</param>
    public static RenderContext Of(Scene scene, Plan plan, CancellationToken cancellation) =>
        plan.IsWide ? new RenderContext<WidePacket>(scene, plan, cancellation) : new RenderContext<Packet>(scene, plan, cancellation);

    public abstract StripCaster NewCaster();

    public abstract IHitConsumer HitsInto(HitMap map);

    /// <summary>Returns rented memory when the picture is done.</summary>
    public abstract void Dispose();
}
