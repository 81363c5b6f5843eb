using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.Runtime.Intrinsics;

namespace RayCaster.Benchmarks;

/// <summary>Embree 3 in a process of its own, which keeps a scene and draws it when asked (Peers/embree_peer.cpp).</summary>
internal sealed class EmbreePeer : IDisposable
{
    private static readonly string[] Calls = ["8", "16", "1m", "nm8", "nm16", "np"];

    private readonly Process process;
    private readonly bool hasUserShapes;

    /// <summary>Compiles the peer; null, after saying why, where that is not possible.</summary>
    public static string? Build(string program)
    {
        var source = Path.Combine(AppContext.BaseDirectory, "Peers", "embree_peer.cpp");
        try
        {
            using var compiler = Process.Start("g++",
                ["-O3", "-march=native", "-ffast-math", "-std=c++17", source, "-o", program, "-lembree3", "-pthread"]);
            compiler.WaitForExit();
            if (compiler.ExitCode == 0) return program;
        }
        catch (Win32Exception)
        {
        }
        Console.WriteLine("Embree is left out: its peer does not build here. On Debian: apt-get install libembree-dev g++");
        return null;
    }

    /// <summary>Starts the peer with a scene, which is written into a file.</summary>
    public static EmbreePeer Start(string program, BenchmarkScene benchmark, string file)
    {
        var scene = benchmark.Create(500, 500);
        if (benchmark.Mesh is { } mesh) PeerScene.WriteMesh(file, scene, mesh);
        else PeerScene.Write(file, scene);
        return new(program, file, scene, Environment.ProcessorCount);
    }

    private EmbreePeer(string program, string sceneFile, Scene scene, int buildThreads)
    {
        var start = new ProcessStartInfo(program, [sceneFile, buildThreads.ToString(CultureInfo.InvariantCulture)])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        };
        process = Process.Start(start)!;
        hasUserShapes = scene.Models.Any(model => model is not Mesh);
    }

    /// <summary>All ways worth trying: instruction set, scene flags, who computes the crossings, and the call. Embree uses no wider vectors than
    /// .NET: with <c>DOTNET_EnableAVX512=0</c> both have AVX2 alone.</summary>
    public IEnumerable<string> Ways =>
        from isa in Vector512.IsHardwareAccelerated ? new[] { "avx2", "best" } : ["avx2"]
        from flags in (string[])["none", "compact"]
        from shapes in hasUserShapes ? new[] { "user", "native" } : ["user"]
        from call in Calls
        select $"{isa} {flags} {shapes} {call}";

    public void Resize(int width, int height) => Ask($"size {width} {height}");

    /// <summary>The milliseconds of one picture.</summary>
    public double Run(string way, Answer answer, int threads) =>
        double.Parse(Ask($"run {way} {(answer == Answer.Hits ? "hits" : "bytes")} {threads}"), CultureInfo.InvariantCulture);

    /// <summary>t and model of each pixel, top line first.</summary>
    public (float[] T, int[] Model) Hits(string way, string file, int pixels)
    {
        Ask($"dump {way} {file}");
        var bytes = File.ReadAllBytes(file);
        var (t, model) = (new float[pixels], new int[pixels]);
        Buffer.BlockCopy(bytes, 0, t, 0, 4 * pixels);
        Buffer.BlockCopy(bytes, 4 * pixels, model, 0, 4 * pixels);
        return (t, model);
    }

    private string Ask(string command)
    {
        process.StandardInput.WriteLine(command);
        process.StandardInput.Flush();
        var answer = process.StandardOutput.ReadLine();
        if (answer is null || answer.StartsWith("error", StringComparison.Ordinal))
            throw new InvalidOperationException($"the Embree peer answers '{command}' with {answer ?? "nothing"}");
        return answer;
    }

    public void Dispose()
    {
        process.StandardInput.Close();
        process.WaitForExit();
        process.Dispose();
    }
}
