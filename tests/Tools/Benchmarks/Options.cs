using System.Globalization;

namespace RayCaster.Benchmarks;

/// <summary>What to measure.</summary>
internal sealed class Options
{
    public const string Help = """
        Measures RayCaster beside its peers, on the same rays, in one run.

          dotnet run -c Release --project tests/Tools/Benchmarks -- [options]

          --scene NAME     Only this scene: room, bumpy-70k, bumpy-1m, bumpy-10m, spheres-100k, or
                           bumpy-N and spheres-N with another number, or a mesh that is hard:
                           inside-N, layers-N, slivers-N, shuffled-N. May be repeated.
          --size WxH       Another size than 1920x1080. May be repeated.
          --threads N      Only this number of threads; otherwise 1 and 2. May be repeated.
          --repeats N      How often each way runs in each comparison; otherwise 15.
          --only PART      Only rays or programs (whole processes).

        Peers: apt-get install libembree-dev povray g++. What is not there is left out, and said.
        """;

    public int Repeats { get; private set; } = 15;

    public List<string> Scenes { get; } = [];

    public List<(int Width, int Height)> Sizes { get; } = [];

    public List<int> Threads { get; } = [];

    public string? Only { get; private set; }

    /// <exception cref="ArgumentException">The command line cannot be understood.</exception>
    public static Options Parse(string[] arguments)
    {
        var options = new Options();
        foreach (var pair in arguments.Chunk(2))
        {
            switch (pair)
            {
                case ["--scene", var name]: options.Scenes.Add(name); break;
                case ["--only", "rays" or "programs"]: options.Only = pair[1]; break;
                case ["--threads", var number]: options.Threads.Add(Number(number)); break;
                case ["--repeats", var number]: options.Repeats = Number(number); break;
                case ["--size", var size] when size.Split('x') is [var width, var height]: options.Sizes.Add((Number(width), Number(height))); break;
                default: throw new ArgumentException($"'{string.Join(' ', pair)}' is no option");
            }
        }
        if (options.Scenes.Count == 0) options.Scenes.AddRange(BenchmarkScene.Names);
        if (options.Sizes.Count == 0) options.Sizes.Add((1920, 1080));
        if (options.Threads.Count == 0) options.Threads.AddRange([1, 2]);
        return options;
    }

    private static int Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number > 0
        ? number
        : throw new ArgumentException($"'{text}' is not a whole number greater than 0");
}
