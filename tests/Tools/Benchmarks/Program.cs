using RayCaster.Benchmarks;

Options options;
try
{
    options = Options.Parse(args);
}
catch (ArgumentException problem)
{
    Console.Error.WriteLine($"{problem.Message}\n\n{Options.Help}");
    return 2;
}

Console.WriteLine(Machine.Description);
using var workshop = new Workshop();
var peer = workshop.BuildEmbreePeer();
var report = new Report();
if (options.Only != "programs")
{
    foreach (var name in options.Scenes)
    {
        var scene = BenchmarkScene.Named(name);
        using var embree = peer is null ? null : workshop.StartEmbree(peer, scene, Environment.ProcessorCount);
        Checks.Run(scene, embree, workshop);
        foreach (var (width, height) in options.Sizes)
            foreach (var threads in options.Threads)
                report.Comparisons.Add(new RayComparison(scene, width, height, threads).Run(embree, options.Repeats, workshop));
    }
}
if (options.Only != "rays") report.Programs.AddRange(new Programs(options, workshop, peer).Run());
Console.WriteLine("\n" + report.Write(options));
return 0;
