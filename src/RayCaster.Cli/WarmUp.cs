using System.Runtime.CompilerServices;

namespace RayCaster.Cli;

/// <summary>
/// Draws the beginning of a scene to nowhere while the whole is being read, so that the runtime compiles the drawing code in the meantime. Reads
/// the beginning of a long file many times, so that the runtime optimises the code that reads models.
/// </summary>
/// <remarks>
/// Where this fails it only costs time of an idle core. Without a warm-up, a mesh of a million triangles at 1920 x 1080 takes a quarter longer from
/// file to picture on two cores.
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

    /// <summary>The number of bytes that are read: all of most scenes, and of a long one so many models that they are drawn in batches.</summary>
    private const int Glimpse = 1 << 14;

    /// <summary>How often the beginning is read. With some eighty models each time, these are enough calls for the runtime to optimise the
    /// code.</summary>
    private const int Readings = 75;

    private const int Width = 128, Height = 64;

    private static int begun;

    /// <summary>Starts the warm-up on another thread, once in a process, if there is more than one core.</summary>
    /// <param name="text">A scene file's text, which may have errors.</param>
    public static void Begin(ReadOnlySpan<byte> text, long pixels)
    {
        if (!RuntimeFeature.IsDynamicCodeCompiled || Environment.ProcessorCount == 1) return; // the first: a native program
        var isLong = text.Length > LongText;
        var start = text[..Math.Min(text.Length, Glimpse)];
        var isPlain = !isLong && !NamesMesh(start);
        if ((isPlain && pixels < ManyPixels) || Interlocked.Exchange(ref begun, 1) != 0) return;
        var beginning = Beginning(start);
        new Thread(() =>
        {
            try
            {
                Scene? scene = null;
                for (var i = 0; i < (isLong ? Readings : 1); i++) scene = SceneReader.Parse(beginning, "", "").Scene;
                Draw(scene ?? Sheet(), isPlain);
            }
            catch (Exception)
            {
                // Nobody sees this picture. If memory is short, drawing the real one fails with a message.
            }
        })
        { IsBackground = true, Name = "warm-up" }.Start();
    }

    /// <summary>The text up to its last complete model, closed like a scene. Empty if it names a mesh, because mesh files must not be read in
    /// advance.</summary>
    internal static byte[] Beginning(ReadOnlySpan<byte> text) =>
        !NamesMesh(text) && text.LastIndexOf("},"u8) is >= 0 and var end ? [.. text[..(end + 1)], .. "]}"u8] : [];

    private static bool NamesMesh(ReadOnlySpan<byte> text) => text.IndexOf("\"mesh\""u8) >= 0;

    internal static void Draw(Scene scene, bool isPlain)
    {
        scene = scene.WithSize(Width, Height);
        using var writer = PictureWriter.Create(PictureFormat.Png, Stream.Null, Width, Height);
        new Renderer(scene, threads: 1) { MayBeSmall = isPlain }.Draw(.., writer.WriteRows);
        writer.Finish();
    }

    /// <summary>A mesh with triangles from less than a pixel to a quarter of the picture.</summary>
    internal static Scene Sheet()
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
        return new(new Camera(new(0, -2, 0.5), new(0.5, 0, 0)), [new Mesh(vertices, [.. indices])]);
    }
}
