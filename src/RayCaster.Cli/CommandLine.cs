using System.Globalization;

namespace RayCaster.Cli;

/// <summary>What the user asks for.</summary>
internal enum Command
{
    Draw,
    Help,
    Version,
    Usage,
}

/// <summary>The command line, understood.</summary>
internal sealed record CommandLine(Command Command)
{
    private static readonly string[] Names =
        ["--output", "--format", "--size", "--threads", "--quiet", "--no-progress", "--version", "--help"];

    /// <summary>The scene file, or "-" for standard input.</summary>
    public string Scene { get; private set; } = "";

    /// <summary>Where the picture goes, "-" for standard output, null for the default.</summary>
    public string? Output { get; private set; }

    /// <summary>The picture's format, null for what the extension says.</summary>
    public PictureFormat? Format { get; private set; }

    /// <summary>The picture's size, null for the scene's.</summary>
    public (int Width, int Height)? Size { get; private set; }

    /// <summary>How many threads cast rays, null for one per core.</summary>
    public int? Threads { get; private set; }

    /// <summary>Whether only errors are printed.</summary>
    public bool Quiet { get; private set; }

    /// <summary>Whether a progress line is unwanted.</summary>
    public bool NoProgress { get; private set; }

    /// <exception cref="ProblemException">The command line cannot be understood.</exception>
    public static CommandLine Parse(string[] arguments)
    {
        if (arguments.Length == 0) return new(Command.Usage);

        var line = new CommandLine(Command.Draw);
        var operands = new List<string>();
        var given = new HashSet<string>();
        var words = new Queue<string>(arguments);
        while (words.TryDequeue(out var word))
        {
            if (word == "--")
            {
                operands.AddRange(words);
                break;
            }
            if (word == "-" || !word.StartsWith('-'))
            {
                operands.Add(word);
                continue;
            }

            var (name, value) = word.StartsWith("--") && word.Split('=', 2) is [var left, var right] ? (left, right) : (word, null);
            name = name switch
            {
                "-o" => "--output",
                "-s" => "--size",
                "-t" => "--threads",
                "-q" => "--quiet",
                "-h" or "-?" => "--help",
                _ => name,
            };
            if (!Names.Contains(name)) throw UnknownOption(name);
            if (!given.Add(name)) throw ProblemException.Usage($"option '{name}' is given twice");
            string Value() => value
                ?? (words.TryDequeue(out var next) ? next : throw ProblemException.Usage($"option '{name}' needs a value"));

            switch (name)
            {
                case "--help": return new(Command.Help);
                case "--version": return new(Command.Version);
                case "--output": line.Output = Value(); break;
                case "--format": line.Format = ParseFormat(Value()); break;
                case "--size": line.Size = ParseSize(Value()); break;
                case "--threads": line.Threads = ParseThreads(Value()); break;
                case "--quiet": line.Quiet = NoValue(name, value); break;
                case "--no-progress": line.NoProgress = NoValue(name, value); break;
            }
        }

        if (operands is ["help", ..]) return new(Command.Help);
        line.Scene = operands switch
        {
            [var scene] when scene.Length > 0 => scene,
            [] or [_] => throw ProblemException.Usage("which scene? Name a scene file, for example scenes/room.json"),
            _ => throw ProblemException.Usage(
                $"one scene at a time, but there are {operands.Count}: {string.Join(", ", operands)}{OutputHint(operands)}"),
        };
        return line;
    }

    private static ProblemException UnknownOption(string name) =>
        ProblemException.Usage($"unknown option '{name}'" + (Spelling.Nearest(name, Names) is { } near ? $"; did you mean '{near}'?" : ""));

    private static string OutputHint(List<string> operands) =>
        operands is [_, var second] && Path.GetExtension(second).ToLowerInvariant() is ".png" or ".ppm"
            ? $"; did you mean -o {second}?"
            : "";

    private static bool NoValue(string name, string? value) =>
        value is null ? true : throw ProblemException.Usage($"option '{name}' takes no value, but '{value}' is given");

    private static PictureFormat ParseFormat(string text) => text switch
    {
        "png" => PictureFormat.Png,
        "ppm" => PictureFormat.Ppm,
        "ppm-text" => PictureFormat.PpmText,
        _ => throw ProblemException.Usage($"'{text}' is not a format: choose png, ppm or ppm-text"),
    };

    private static (int Width, int Height) ParseSize(string text)
    {
        if (text.Split('x', 'X') is not [var w, var h] || ParseCount(w) is not { } width || ParseCount(h) is not { } height)
            throw ProblemException.Usage($"'{text}' is not a size: write width and height in pixels as in 640x480");
        if (width > Camera.MaxSide || height > Camera.MaxSide || (long)width * height > Camera.MaxPixels)
            throw ProblemException.Usage(
                $"'{text}' is too large: width and height are at most {Camera.MaxSide}, their product at most {Camera.MaxPixels}");
        return (width, height);
    }

    private static int ParseThreads(string text) => ParseCount(text) is { } threads and <= 1024
        ? threads
        : throw ProblemException.Usage($"'{text}' is not a number of threads: it is a whole number from 1 to 1024");

    private static int? ParseCount(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var count) && count > 0 ? count : null;
}
