using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace RayCaster.Benchmarks;

/// <summary>A temporary folder, the programs built in it, and processes and their times.</summary>
internal sealed class Workshop : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("raycaster-benchmarks-").FullName;

    public string PathOf(string file) => Path.Combine(folder, file);

    /// <summary>The console app as it was built with the benchmark.</summary>
    public static string App { get; } = Path.Combine(AppContext.BaseDirectory, "raycaster");

    /// <summary>The Embree peer, or null, after saying why, where it cannot be built.</summary>
    public string? BuildEmbreePeer()
    {
        var program = PathOf("embree_peer");
        var source = Path.Combine(AppContext.BaseDirectory, "Peers", "embree_peer.cpp");
        string[] options = ["-O3", "-march=native", "-ffast-math", "-std=c++17", source, "-o", program, "-lembree3", "-pthread"];
        try
        {
            Run("g++", options);
            return program;
        }
        catch (Exception e) when (e is Win32Exception or InvalidOperationException)
        {
            Console.WriteLine("Embree is left out: its peer does not build here. On Debian: apt-get install libembree-dev g++");
            return null;
        }
    }

    /// <summary>Starts the Embree peer with a scene.</summary>
    public EmbreePeer StartEmbree(string program, BenchmarkScene benchmark, int buildThreads)
    {
        var scene = benchmark.Create(500, 500);
        var file = PathOf($"{benchmark.Name}.scene");
        if (benchmark.Mesh is { } mesh) PeerScene.WriteMesh(file, scene, mesh);
        else PeerScene.Write(file, scene);
        return new(program, file, scene, buildThreads);
    }

    /// <summary>POV-Ray, or null, after saying so, where it is not there.</summary>
    public static string? FindPovRay()
    {
        foreach (var directory in (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator))
            if (File.Exists(Path.Combine(directory, "povray")))
                return Path.Combine(directory, "povray");
        Console.WriteLine("POV-Ray is left out: it is not there. On Debian: apt-get install povray");
        return null;
    }

    /// <summary>An app that says hello, with the settings of ours: what any .NET process costs.</summary>
    public string BuildHello()
    {
        Directory.CreateDirectory(PathOf("hello"));
        File.WriteAllText(PathOf("hello/Program.cs"), "System.Console.WriteLine(\"Hello, World!\");\n");
        File.WriteAllText(PathOf("hello/hello.csproj"), """
            <Project Sdk="Microsoft.NET.Sdk">
              <PropertyGroup>
                <OutputType>Exe</OutputType>
                <TargetFramework>net10.0</TargetFramework>
                <InvariantGlobalization>true</InvariantGlobalization>
              </PropertyGroup>
            </Project>
            """);
        Run("dotnet", ["build", "-c", "Release", "-o", PathOf("hello/out"), PathOf("hello/hello.csproj")]);
        return PathOf("hello/out/hello");
    }

    /// <summary>The console app as a native program (docs/native.md), or null, after saying why, where it cannot be compiled.</summary>
    public string? PublishNative()
    {
        try
        {
            Run("dotnet", ["publish", ProjectFolder.PathOf("src/RayCaster.Cli"), "-p:PublishAot=true", "-o", PathOf("native")]);
            return PathOf("native/raycaster");
        }
        catch (InvalidOperationException)
        {
            Console.WriteLine("The native program is left out: it cannot be compiled here. It needs a linker, on Debian: apt-get install gcc");
            return null;
        }
    }

    /// <summary>Runs a program to its end, which must be a good one.</summary>
    /// <returns>The milliseconds on the clock, and those of all cores, if the system tells.</returns>
    public (double Elapsed, double Processor) Run(string program, IEnumerable<string> arguments)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            WorkingDirectory = folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        var processor = ProcessorTimeOfChildren();
        var clock = Stopwatch.GetTimestamp();
        using var process = Process.Start(start)!;
        var error = process.StandardError.ReadToEndAsync();
        process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        var elapsed = Stopwatch.GetElapsedTime(clock).TotalMilliseconds;
        if (process.ExitCode != 0)
            throw new InvalidOperationException($"{program} {string.Join(' ', start.ArgumentList)} ends with {process.ExitCode}:\n{error.Result}");
        return (elapsed, ProcessorTimeOfChildren() - processor);
    }

    /// <summary>The milliseconds that the processor has spent on this thread; NaN if the system does not tell.</summary>
    public static double ProcessorTimeOfThread()
    {
        const int ThreadCpuTime = 3;
        if (!OperatingSystem.IsLinux()) return double.NaN;
        var time = new long[2]; // seconds and nanoseconds
        return GetClock(ThreadCpuTime, time) == 0 ? time[0] * 1e3 + time[1] / 1e6 : double.NaN;
    }

    private static double ProcessorTimeOfChildren()
    {
        if (!OperatingSystem.IsLinux()) return double.NaN;
        const int Children = -1;
        var usage = new long[36]; // seconds and microseconds in user mode, then in the kernel, then what is of no interest here
        return GetResourceUsage(Children, usage) == 0 ? (usage[0] + usage[2]) * 1e3 + (usage[1] + usage[3]) / 1e3 : double.NaN;
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int GetClock(int clock, long[] time);

    [DllImport("libc", EntryPoint = "getrusage")]
    private static extern int GetResourceUsage(int who, long[] usage);

    public void Dispose() => Directory.Delete(folder, recursive: true);
}
