using System.Globalization;

namespace RayCaster.Benchmarks;

/// <summary>One comparison of whole processes.</summary>
/// <param name="What">What is done.</param>
/// <param name="Measure">What is divided by what.</param>
/// <param name="Ratio">The quotient.</param>
internal sealed record ProgramComparison(string What, string Measure, Ratio Ratio);

/// <summary>Whole processes from start to end, in turn: our app, an app that only says hello, POV-Ray, Embree from a file.</summary>
internal sealed class Programs(Options options, Workshop workshop, string? embree)
{
    private readonly (string Name, string Path)[] apps = workshop.PublishNative() is { } native
        ? [("as built", Workshop.App), ("native", native)]
        : [("as built", Workshop.App)];

    public IEnumerable<ProgramComparison> Run()
    {
        Console.WriteLine("\nWhole processes");
        foreach (var comparison in Hello().Concat(PovRay()).Concat(Ply()))
        {
            Console.WriteLine($"  {comparison.What}: {comparison.Measure}: {Text.Ratio(comparison.Ratio.Median)}");
            yield return comparison;
        }
    }

    /// <summary>The processor's time, because a machine with idle cores hides what start-up costs.</summary>
    private IEnumerable<ProgramComparison> Hello()
    {
        var hello = workshop.BuildHello();
        string[] arguments = [ProjectFolder.PathOf("scenes/room.json"), "-o", workshop.PathOf("room.png"), "--quiet"];
        var theirs = new Way("hello", Answer.Bytes, _ => workshop.Run(hello, []).Processor);
        Way[] ours = [.. apps.Select(app => new Way(app.Name, Answer.Bytes, _ => workshop.Run(app.Path, arguments).Processor))];
        Measure([theirs, .. ours], Math.Max(options.Repeats, 7));
        return ours.Select(way => new ProgramComparison($"the course's room, 500×500, file to PNG, {way.Name}",
            "our processor time / that of an app that only says hello", Ratio.Of(theirs, way)));
    }

    private IEnumerable<ProgramComparison> PovRay()
    {
        if (Workshop.FindPovRay() is not { } povray) yield break;
        foreach (var name in options.Scenes.Where(name => name != "bumpy-10m")) // its text would be a gigabyte
        {
            var benchmark = BenchmarkScene.Named(name);
            foreach (var (width, height) in options.Sizes)
            {
                var scene = benchmark.Create(width, height);
                var (json, pov) = (workshop.PathOf($"{name}.json"), workshop.PathOf($"{name}.pov"));
                SceneFiles.WriteScene(json, scene, benchmark.Mesh);
                SceneFiles.WritePov(pov, scene, benchmark.Mesh);
                foreach (var threads in options.Threads)
                {
                    var ours = OurApps(json, width, height, threads);
                    var theirs = new Way("POV-Ray", Answer.Bytes, _ => workshop.Run(povray,
                        [$"+I{pov}", $"+O{workshop.PathOf("pov.png")}", $"+W{width}", $"+H{height}", $"+WT{threads}", "File_Gamma=1", "-D", "-A",
                            "-GA"]).Elapsed);
                    var what = $"{benchmark.Title}, {width}×{height}, threads: {threads}, file to PNG";
                    Measure([.. ours, theirs], Math.Min(options.Repeats, 3));
                    foreach (var way in ours) yield return new($"{what}, {way.Name}", "POV-Ray's time / ours", Ratio.Of(way, theirs));
                    CheckPov(what);
                }
            }
        }
    }

    /// <summary>POV-Ray has drawn the same picture: all but outlines, where its rays differ in the last digits.</summary>
    private void CheckPov(string what)
    {
        var (ours, theirs) = (PictureFile.Read(workshop.PathOf("ours.png")).Rgb, PictureFile.Read(workshop.PathOf("pov.png")).Rgb);
        var same = ours.Zip(theirs, (a, b) => Math.Abs(a - b) <= 1 ? 1 : 0).Sum() / (double)ours.Length;
        if (same < 0.99) throw new InvalidOperationException($"{what}: POV-Ray draws the same only in {100 * same:0.0} % of the channels");
    }

    private IEnumerable<ProgramComparison> Ply()
    {
        if (embree is null) yield break;
        const int Width = 1920, Height = 1080;
        foreach (var name in options.Scenes.Where(name => name is "bumpy-70k" or "bumpy-1m"))
        {
            var benchmark = BenchmarkScene.Named(name);
            var scene = benchmark.Create(Width, Height);
            var (json, camera) = (workshop.PathOf($"{name}.json"), workshop.PathOf("camera.scene"));
            SceneFiles.WriteScene(json, scene, benchmark.Mesh);
            PeerScene.Write(camera, scene, withModels: false);
            foreach (var threads in options.Threads)
            {
                var ours = OurApps(json, Width, Height, threads);
                var theirs = new[] { "low", "medium" }.Select(quality => new Way(quality, Answer.Bytes, _ => workshop.Run(embree,
                    [camera, Number(threads), workshop.PathOf($"{name}.ply"), Number(Width), Number(Height), quality]).Elapsed)).ToArray();
                Measure([.. ours, .. theirs], options.Repeats);
                var best = theirs.MinBy(way => way.Median)!;
                foreach (var way in ours)
                    yield return new($"{benchmark.Title} from a binary PLY, {Width}×{Height}, threads: {threads}, {way.Name}",
                        $"Embree's time ({best.Name} build quality, no PNG) / ours (with a PNG)", Ratio.Of(way, best));
            }
        }
    }

    private Way[] OurApps(string scene, int width, int height, int threads)
    {
        string[] arguments =
            [scene, "-o", workshop.PathOf("ours.png"), "--quiet", "--size", $"{width}x{height}", "--threads", Number(threads)];
        return [.. apps.Select(app => new Way(app.Name, Answer.Bytes, _ => workshop.Run(app.Path, arguments).Elapsed))];
    }

    /// <summary>Runs each once, so that the files are in memory, and then all in turn.</summary>
    private static void Measure(Way[] ways, int rounds)
    {
        Interleaving.WarmUp(ways, milliseconds: 0);
        Interleaving.Run(ways, rounds);
    }

    private static string Number(int number) => number.ToString(CultureInfo.InvariantCulture);
}
