using System.Globalization;

namespace RayCaster.Benchmarks;

/// <summary>What to measure.</summary>
internal sealed class Options
{
    public const string Help = """
        Measures RayCaster beside its peers, on the same rays, in one run.

          dotnet run -c Release --project tests/Benchmarks -- [options]

          --quick          A minute: small pictures, few repeats.
          --scene NAME     Only this scene: room, bumpy-70k, bumpy-1m, bumpy-10m, spheres-100k, or
                           bumpy-N and spheres-N with another number, or a mesh that is hard:
                           inside-N, layers-N, slivers-N, shuffled-N. May be repeated.
          --size WxH       Only this size; otherwise 1920x1080 and 500x500. May be repeated.
          --threads N      Only this number of threads; otherwise 1 and 2. May be repeated.
          --repeats N      How often each way runs in each comparison; otherwise 15.
          --only PART      Only rays or programs (whole processes). May be repeated.
          --help           Shows this.

        Peers: apt-get install libembree-dev povray g++. What is not there is left out, and said.
        """;

    public bool Quick { get; private set; }

    public bool ShowHelp { get; private set; }

    public int Repeats { get; private set; } = 15;

    public List<string> Scenes { get; } = [];

    public List<(int Width, int Height)> Sizes { get; } = [];

    public List<int> Threads { get; } = [];

    private readonly List<string> parts = [];

    public bool Does(string part) => parts.Count == 0 || parts.Contains(part);

    /// <exception cref="ArgumentException">The command line cannot be understood.</exception>
    public static Options Parse(string[] arguments)
    {
        var options = new Options();
        int? repeats = null;
        for (var i = 0; i < arguments.Length; i++)
        {
            string Value(string[]? choices = null)
            {
                if (i + 1 == arguments.Length) throw new ArgumentException($"{arguments[i]} needs a value");
                var value = arguments[++i];
                if (choices is not null && !choices.Contains(value))
                    throw new ArgumentException($"'{value}' is none of {string.Join(", ", choices)}");
                return value;
            }

            switch (arguments[i])
            {
                case "--quick": options.Quick = true; break;
                case "--help": options.ShowHelp = true; break;
                case "--scene": options.Scenes.Add(Value()); break;
                case "--only": options.parts.Add(Value(["rays", "programs"])); break;
                case "--threads": options.Threads.Add(Number(Value())); break;
                case "--repeats": repeats = Number(Value()); break;
                case "--size":
                    var sides = Value().Split('x');
                    if (sides.Length != 2) throw new ArgumentException("a size is written 1920x1080");
                    options.Sizes.Add((Number(sides[0]), Number(sides[1])));
                    break;
                case var other: throw new ArgumentException($"unknown option '{other}'");
            }
        }

        if (options.Quick) options.Repeats = 5;
        options.Repeats = repeats ?? options.Repeats;
        if (options.Scenes.Count == 0) options.Scenes.AddRange(options.Quick ? ["room", "bumpy-70k", "spheres-100k"] : BenchmarkScene.Names);
        if (options.Sizes.Count == 0) options.Sizes.AddRange(options.Quick ? [(500, 500)] : [(1920, 1080), (500, 500)]);
        if (options.Threads.Count == 0) options.Threads.AddRange(options.Quick ? [1] : [1, 2]);
        return options;
    }

    private static int Number(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number > 0
        ? number
        : throw new ArgumentException($"'{text}' is not a whole number greater than 0");
}
