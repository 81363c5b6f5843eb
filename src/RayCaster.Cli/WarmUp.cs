using System.Runtime.CompilerServices;

namespace RayCaster.Cli;

/// <summary>
/// Draws a small picture to nowhere while a scene file is being read, so that the runtime compiles the drawing code in the meantime. Also reads the
/// beginning of a long file many times, so that the runtime optimises the code that reads models.
/// </summary>
/// <remarks>
/// Guesses the scene's models from its text; a wrong guess only costs time of an idle core. Without a warm-up, a mesh of a million triangles at
/// 1920 x 1080 takes a quarter longer from file to picture on two cores.
/// </remarks>
internal static class WarmUp
{
    /// <summary>
    /// Fewer pixels of few models need little code: two threads that compile at the same time would cost more processor time than they save on
    /// the clock.
    /// </summary>
    private const int ManyPixels = 1 << 20;

    /// <summary>A longer text has so many models that the engine draws them in batches.</summary>
    private const int LongText = 1 << 16;

    /// <summary>The number of bytes that are searched: all of most scenes.</summary>
    private const int Glimpse = 1 << 13;

    /// <summary>How often the beginning is read. With some forty models each time, these are enough calls for the runtime to optimise the
    /// code.</summary>
    private const int Readings = 150;

    private const int Width = 128, Height = 64, CrowdSize = 100;

    private static int begun;

    /// <summary>Starts the warm-up on another thread, once in a process, if there is more than one core.</summary>
    /// <param name="text">A scene file's text, which may have errors.</param>
    /// <param name="pixels">The number of pixels, if it is known already.</param>
    public static void Begin(ReadOnlySpan<byte> text, long pixels)
    {
        if (!RuntimeFeature.IsDynamicCodeCompiled) return; // a native program
        var isLong = text.Length > LongText;
        var start = text[..Math.Min(text.Length, Glimpse)];
        var isPlain = !isLong && start.IndexOf("\"mesh\""u8) < 0;
        if (isPlain && pixels < ManyPixels) return;
        if (Environment.ProcessorCount == 1 || Interlocked.Exchange(ref begun, 1) != 0) return;
        var (models, beginning) = (Guess(start, isLong ? CrowdSize : 1), isLong ? Beginning(start) : []);
        new Thread(() =>
        {
            try
            {
                for (var i = 0; i < Readings && beginning.Length > 0; i++) SceneReader.Parse(beginning, "", "");
                Draw(models, isPlain);
            }
            catch (Exception)
            {
                // Nobody sees this picture. If memory is short, drawing the real one fails with a message.
            }
        })
        { IsBackground = true, Name = "warm-up" }.Start();
    }

    /// <summary>Some models of each kind that occurs in a text.</summary>
    internal static List<Model> Guess(ReadOnlySpan<byte> text, int count)
    {
        var models = new List<Model>();
        for (var i = 0; i < count; i++)
        {
            var at = new Vector3(0.01 * i, 0, -0.01 * i);
            if (text.IndexOf("\"sphere\""u8) >= 0) models.Add(Model.Of(new Sphere(at, 0.1)));
            if (text.IndexOf("\"aabb\""u8) >= 0) models.Add(Model.Of(new Aabb(at, at + new Vector3(0.1, 0.1, 0.1))));
            if (text.IndexOf("\"circle\""u8) >= 0) models.Add(Model.Of(new Circle(at, new(0, 1, 0), 0.1)));
            if (text.IndexOf("\"triangle\""u8) >= 0)
                models.Add(Model.Of(new Triangle(at, at + new Vector3(0.1, 0, 0), at + new Vector3(0, 0, 0.1))));
        }
        if (text.IndexOf("\"plane\""u8) >= 0) models.Add(Model.Of(new Plane(new(0, 0, -1), new(0, 0, 1))));
        if (text.IndexOf("\"mesh\""u8) >= 0) models.Add(Sheet());
        return models;
    }

    /// <summary>The text up to its last complete model, closed like a scene. Empty if it names a mesh, because mesh files must not be read in
    /// advance.</summary>
    internal static byte[] Beginning(ReadOnlySpan<byte> text) =>
        text.IndexOf("\"mesh\""u8) < 0 && text.LastIndexOf("},"u8) is >= 0 and var end ? [.. text[..(end + 1)], .. "]}"u8] : [];

    internal static void Draw(List<Model> models, bool isPlain)
    {
        var scene = new Scene(new Camera(new(new(0, -2, 0.5), new(0.5, 0, 0)) { Width = Width, Height = Height }), models);
        using var writer = PictureWriter.Create(PictureFormat.Png, Stream.Null, Width, Height);
        new Renderer(scene, threads: 1) { MayBeSmall = isPlain }.Draw(.., writer.WriteRows);
        writer.Finish();
    }

    /// <summary>A mesh with triangles from less than a pixel to a quarter of the picture.</summary>
    private static Mesh Sheet()
    {
        const int Side = 16;
        var vertices = new Vector3[Side * Side];
        var indices = new List<int>();
        for (var i = 0; i < vertices.Length; i++)
        {
            double x = i % Side / (Side - 1.0), z = i / Side / (Side - 1.0);
            vertices[i] = new(x * x * x, 0.1 * x * z, z * z);
            if (i % Side > 0 && i >= Side) indices.AddRange([i, i - 1, i - Side, i - 1, i - Side - 1, i - Side]);
        }
        return new(vertices, [.. indices]);
    }
}
