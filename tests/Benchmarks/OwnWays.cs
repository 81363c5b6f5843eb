extern alias ClassLab;
extern alias StructLab;
using System.Diagnostics;

namespace RayCaster.Benchmarks;

/// <summary>The ways that need nothing but .NET: the engine, its definition, and the lab.</summary>
internal static class OwnWays
{
    /// <summary>How many crossings a way without a hierarchy may compute in one run; of a larger picture it casts evenly spread pixels.</summary>
    private const double Crossings = 2e7;

    /// <summary>The engine, exact, as the first of many frames: all that it prepares for a scene is counted. Its map is kept from run to run, as
    /// Embree's is.</summary>
    public static Way Exact(BenchmarkScene scene, int width, int height) =>
        Exact("exact t", () => Fresh(scene, width, height), SpatialOrder.Of, width, height);

    /// <summary>The same as a later frame: the scene's models have been drawn before, from another side.</summary>
    public static Way LaterExact(BenchmarkScene scene, int width, int height) =>
        Exact("exact t, later frame", Moving(scene, width, height), scene => scene, width, height);

    /// <summary>The engine, only the picture's bytes, as the first of many frames.</summary>
    public static Way Bytes(BenchmarkScene scene, int width, int height) =>
        Bytes("bytes", () => Fresh(scene, width, height), SpatialOrder.Of, width, height);

    /// <summary>The same as a later frame.</summary>
    public static Way LaterBytes(BenchmarkScene scene, int width, int height) =>
        Bytes("bytes, later frame", Moving(scene, width, height), scene => scene, width, height);

    /// <summary>The bytes as the program draws a single picture: in bands, which it writes one after another.</summary>
    public static Way SinglePicture(BenchmarkScene scene, int width, int height) => new("bytes of a single picture", Answer.Bytes, threads =>
    {
        var fresh = Fresh(scene, width, height);
        return Time(threads, () => new Renderer(SpatialOrder.Of(fresh), threads).Draw(.., _ => { }));
    });

    /// <param name="ordered">Brings random meshes into an order; of the kept scene that is done.</param>
    private static Way Exact(string name, Func<Scene> next, Func<Scene, Scene> ordered, int width, int height)
    {
        var hits = new Lazy<HitMap>(() => new(width, height));
        return new(name, Answer.Hits, threads =>
        {
            var (scene, map) = (next(), hits.Value);
            return Time(threads, () => new Renderer(ordered(scene), threads) { ManyFrames = true }.CastHits(map));
        });
    }

    /// <inheritdoc cref="Exact(string, Func{Scene}, Func{Scene, Scene}, int, int)"/>
    private static Way Bytes(string name, Func<Scene> next, Func<Scene, Scene> ordered, int width, int height)
    {
        var picture = new Lazy<Picture>(() => new(width, height));
        return new(name, Answer.Bytes, threads =>
        {
            var (scene, kept) = (next(), picture.Value);
            return Time(threads, () => new Renderer(ordered(scene), threads) { ManyFrames = true }.DrawInto(kept));
        });
    }

    /// <summary>The definition, one ray after another.</summary>
    public static Way Scalar(BenchmarkScene benchmark, int width, int height)
    {
        var scene = benchmark.Create(width, height);
        var rgb = new byte[width * height * 3];
        var step = Step(benchmark, width, height);
        return new("scalar definition", Answer.Bytes, () => Scaled(step, width * height, () =>
        {
            for (var i = 0; i < width * height; i += step)
            {
                var ray = ScalarRenderer.Cast(scene, i % width, height - 1 - i / width);
                (rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
            }
        }));
    }

    /// <summary>The lab of the course, src/RayCaster.Lab.</summary>
    public static Way NaiveClass(BenchmarkScene scene, int width, int height) =>
        Naive("naive, class Vector3", scene, width, height, WithClasses(scene.Create(width, height)));

    /// <summary>The same with a struct Vector3.</summary>
    public static Way NaiveStruct(BenchmarkScene scene, int width, int height) =>
        Naive("naive, struct Vector3", scene, width, height, WithStructs(scene.Create(width, height)));

    /// <summary>How the lab draws a pixel of a scene: column from the left, row from the bottom.</summary>
    public static Func<int, int, (byte R, byte G, byte B)> WithClasses(Scene scene)
    {
        var lab = ClassLab::Lab.SceneFile.Of(scene);
        return (column, row) => lab.CastRay(column, row).ToBytes();
    }

    /// <inheritdoc cref="WithClasses"/>
    public static Func<int, int, (byte R, byte G, byte B)> WithStructs(Scene scene)
    {
        var lab = StructLab::Lab.SceneFile.Of(scene);
        return (column, row) => lab.CastRay(column, row).ToBytes();
    }

    private static Way Naive(string name, BenchmarkScene scene, int width, int height, Func<int, int, (byte R, byte G, byte B)> cast)
    {
        var rgb = new byte[width * height * 3];
        var step = Step(scene, width, height);
        return new(name, Answer.Bytes, () => Scaled(step, width * height, () =>
        {
            for (var i = 0; i < width * height; i += step)
                (rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) = cast(i % width, height - 1 - i / width);
        }));
    }

    /// <summary>Every how many pixels a way without a hierarchy casts; 1 for the whole picture.</summary>
    public static int Step(BenchmarkScene scene, int width, int height)
    {
        var pixels = width * height;
        var rays = Math.Max(8, Crossings / scene.ModelCount);
        if (rays >= pixels) return 1;
        var step = (int)(pixels / rays);
        while (Gcd(step, width) != 1) step++; // spread over the columns, too
        return step;
    }

    private static int Gcd(int a, int b) => b == 0 ? a : Gcd(b, a % b);

    private static double Scaled(int step, int pixels, Action work) => Time(1, work) * pixels / ((pixels + step - 1) / step);

    private static Scene Fresh(BenchmarkScene scene, int width, int height)
    {
        var fresh = scene.Create(width, height);
        GC.Collect();
        return fresh;
    }

    /// <summary>The same models in each frame, and a camera that swings by some degrees.</summary>
    private static Func<Scene> Moving(BenchmarkScene scene, int width, int height)
    {
        const int Frames = 16, OfOrbit = 720;
        var (kept, frame) = (new Lazy<Scene>(() => SpatialOrder.Of(scene.Create(width, height))), 0);
        return () => kept.Value with { Camera = CameraMotion.Orbit(kept.Value.Camera, frame++ % Frames, OfOrbit) };
    }

    /// <summary>The milliseconds that work takes: on one thread its processor time, which other work of the machine hardly changes.</summary>
    private static double Time(int threads, Action work)
    {
        if (threads == 1 && Workshop.ProcessorTimeOfThread() is var before && !double.IsNaN(before))
        {
            work();
            return Workshop.ProcessorTimeOfThread() - before;
        }
        var start = Stopwatch.GetTimestamp();
        work();
        return Stopwatch.GetElapsedTime(start).TotalMilliseconds;
    }
}
