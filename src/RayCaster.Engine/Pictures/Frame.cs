namespace RayCaster.Engine;

/// <summary>What all threads share that draw one picture.</summary>
internal abstract class Frame : IDisposable
{
    /// <summary>Kernels for single kinds of shape save half of the time, but compiling them takes as long as casting some ten million rays. They are
    /// used for a picture of at least so many pixels, or if many pictures follow each other, and always in a native program.</summary>
    private const long PixelsOfLongWork = 1 << 24;

    private readonly int threads;

    protected Frame(Scene scene, int threads, bool manyFrames)
    {
        (Scene, this.threads) = (scene, threads);
        IsLong = manyFrames || !RuntimeFeature.IsDynamicCodeCompiled || (long)scene.Camera.Width * scene.Camera.Height >= PixelsOfLongWork;
    }

    /// <summary>Whether it pays to compile a kernel for each kind of shape.</summary>
    public bool IsLong { get; }

    public Scene Scene { get; }

    /// <summary>Turns hits into bytes; made on first use.</summary>
    public HitShader Shader => field ??= new(Scene, IsLong, threads);

    /// <summary>A frame for the widest packets of the machine; everything else is generic over this choice.</summary>
    public static Frame Of(Scene scene, int threads, bool manyFrames) => Vector512.IsHardwareAccelerated
        ? new Frame<WidePacket>(scene, threads, manyFrames)
        : new Frame<Packet>(scene, threads, manyFrames);

    /// <summary>A thread's caster.</summary>
    /// <param name="isPlain">Whether each ray is simply intersected with each model near its pixel.</param>
    public abstract IStripCaster NewCaster(bool isPlain);

    public abstract IHitConsumer HitsInto(HitMap map);

    /// <summary>Returns rented memory when the picture is done.</summary>
    public abstract void Dispose();
}
