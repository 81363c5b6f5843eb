namespace RayCaster.Engine;

/// <summary>What all threads share that draw one picture.</summary>
internal abstract class Frame(Scene scene, int threads, bool manyFrames) : IDisposable
{
    /// <summary>Kernels for single kinds of shape save half of the time, but compiling them takes as long as casting some ten million rays. They are
    /// used for a picture of at least this many pixels, or if many pictures follow each other, and always in a native program.</summary>
    private const long PixelsOfLongWork = 1 << 24;

    /// <summary>Whether it pays to compile a kernel for each kind of shape.</summary>
    public bool UsesShapeKernels { get; } =
        manyFrames || !RuntimeFeature.IsDynamicCodeCompiled || (long)scene.Camera.Width * scene.Camera.Height >= PixelsOfLongWork;

    protected bool ManyFrames => manyFrames;

    protected int Threads => threads;

    public Scene Scene => scene;

    /// <summary>Turns hits into bytes; made on first use.</summary>
    public HitShader Shader => field ??= new(scene, UsesShapeKernels, threads);

    /// <summary>A frame for the widest packets of the machine; everything else is generic over this choice.</summary>
    /// <param name="cancellation">Stops the preparation of the models with an <see cref="OperationCanceledException"/>.</param>
    public static Frame Of(Scene scene, int threads, bool manyFrames, CancellationToken cancellation) =>
        Vector512.IsHardwareAccelerated
            ? new Frame<WidePacket>(scene, threads, manyFrames, cancellation)
            : new Frame<Packet>(scene, threads, manyFrames, cancellation);

    /// <summary>A thread's caster.</summary>
    public abstract IStripCaster NewCaster();

    public abstract IHitConsumer HitsInto(HitMap map);

    /// <summary>Returns rented memory when the picture is done.</summary>
    public abstract void Dispose();
}
