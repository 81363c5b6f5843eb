using RayCaster.Benchmarks;

if (args is ["write", var folder, .. var named])
{
    Directory.CreateDirectory(folder);
    foreach (var name in Scenes(named)) SceneFiles.WriteScene(Path.Combine(folder, $"{name}.json"), BenchmarkScene.Named(name));
    return;
}
var rounds = args is [var first, ..] && int.TryParse(first, out var number) ? number : 15;
Console.WriteLine($"Measured on: {Machine.Description}. {rounds} rounds.");
using var temporary = new TemporaryFolder();
var peer = EmbreePeer.Build(temporary["embree_peer"]);
var comparisons = new List<RayComparison>();
foreach (var name in Scenes(args.Where(word => !int.TryParse(word, out _))))
{
    var scene = BenchmarkScene.Named(name);
    using var embree = peer is null ? null : EmbreePeer.Start(peer, scene, temporary["scene"]);
    foreach (var threads in (int[])[1, 2]) comparisons.Add(new RayComparison(scene, threads).Run(embree, rounds, temporary["hits"]));
}
Console.WriteLine($"\n| scene | threads | {string.Join(" | ", comparisons[0].Own.Select(way => way.Name))} | Embree agrees |");
Console.WriteLine("|---|---|--:|--:|--:|--:|--:|--:|");
foreach (var c in comparisons)
{
    var ratios = c.Own.Select(way => c.BestEmbree(way.Answer) is { } best ? Ratio.Of(way, best).ToString() : "–");
    Console.WriteLine($"| {c.Scene.Title} | {c.Threads} | {string.Join(" | ", ratios)} | {100 * c.Agreement:0.00} % |");
}

static string[] Scenes(IEnumerable<string> named) => named.ToArray() is { Length: > 0 } some ? some : BenchmarkScene.Names;
