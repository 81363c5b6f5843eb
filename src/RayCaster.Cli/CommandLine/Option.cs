namespace RayCaster.Cli;

/// <summary>An option, declared once: the command line is read by it, and the help page is printed from it.</summary>
/// <param name="names">For example "-o, --output"; the last one is used in messages. Not -c, -f, -r, -a, -p, -v or -e: "dotnet run" uses these
/// itself.</param>
/// <param name="value">The value's name in the help page; null for a switch, which has no value.</param>
internal abstract class Option(string names, string? value, string help)
{
    internal const int MaxThreads = 1024, MaxThreadsPerCore = 4;

    public static readonly Option<PictureFormat?> Format = new("--format", "<format>",
        "png, ppm or ppm-text (PPM in readable numbers). [default: by the file's extension]", "png, ppm or ppm-text",
        text => text switch { "png" => PictureFormat.Png, "ppm" => PictureFormat.Ppm, "ppm-text" => PictureFormat.PpmText, _ => null });
    public static readonly Option<(int Width, int Height)?> Size = new("-s, --size", "<W>x<H>",
        "Overrides the scene's picture size, in pixels.", "width and height in pixels as in 640x480", ReadSize);
    public static readonly Option<int?> Threads = new("-t, --threads", "<n>",
        "How many threads cast rays. [default: one per core]", $"a whole number from 1 to {MaxThreads:N0}", ReadThreads);
    public static readonly Option<bool> Everything = Switch("--all",
        "Tries everything, however long it takes. Otherwise the search ends after an amount of work that takes some six seconds.");
    public static readonly Option<bool> Quiet = Switch("-q, --quiet", "Prints errors only.");
    public static readonly Option<bool> Version = Switch("--version", "Shows the version.");
    public static readonly Option<bool> Help = Switch("-?, -h, --help", "Shows this help. Under \"dotnet run\" write it after \"--\".");

    public string[] Names { get; } = names.Split(", ");

    public string Name => Names[^1];

    public bool TakesValue => value is not null;

    /// <summary>The words that a list may have; none if its value is no list.</summary>
    public IReadOnlyList<string> Known { get; private init; } = [];

    /// <summary>The option in the help page's table: names without a short one begin where others have their long one.</summary>
    public string Usage => $"{(Names.Length == 1 ? "    " : "")}{names}{(value is null ? "" : " ")}{value}";

    public string HelpText => help;

    public abstract string Takes { get; }

    public abstract object? Read(string text);

    public static Option<bool> Switch(string names, string help) => new(names, null, help, "", _ => true);

    public static Option<string> Text(string names, string value, string help) => new(names, value, help, "", text => text);

    public static Option<int?> Count(string names, string help, int most) =>
        new(names, "<n>", help, $"a whole number from 1 to {most:N0}", text => ReadCount(text) is { } count && count <= most ? count : null);

    public static Option<string[]> List(string names, string value, string help, IReadOnlyList<string> known) =>
        new(names, value, help, $"words such as {string.Join(',', known.Take(8))}", text => ReadList(text, ',', known)) { Known = known };

    /// <summary>The words of a list, each once; null if it has none.</summary>
    public static string[]? ReadList(string text, char separator, IReadOnlyList<string> known)
    {
        var words = text.Split(separator, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (Array.Find(words, word => !known.Contains(word)) is { } unknown)
            throw ProblemException.Usage($"unknown name '{unknown}' in '{text}', a list of names joined by '{separator}'"
                + Spelling.DidYouMean(unknown, known, quote: '\''));
        return words.Length == 0 ? null : [.. words.Distinct()];
    }

    /// <summary>A whole number greater than 0; null for any other text.</summary>
    public static int? ReadCount(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var count) && count > 0 ? count : null;

    /// <summary>More threads than a few per core only need memory.</summary>
    private static int? ReadThreads(string text) =>
        ReadCount(text) is { } count && count <= MaxThreads ? Math.Min(count, MaxThreadsPerCore * Environment.ProcessorCount) : null;

    private static (int Width, int Height)? ReadSize(string text)
    {
        if (text.Split('x', 'X') is not [var w, var h] || ReadCount(w) is not { } width || ReadCount(h) is not { } height) return null;
        if (width > Camera.MaxSide || height > Camera.MaxSide || (long)width * height > Camera.MaxPixels)
            throw ProblemException.Usage(
                $"'{text}' is too large: width and height are at most {Camera.MaxSide:N0}, their product at most {Camera.MaxPixels:N0}");
        return (width, height);
    }
}

/// <param name="takes">What the value must be, as in "option '--size' takes …".</param>
/// <param name="read">Gives the value that a text means; null if it means none.</param>
internal sealed class Option<T>(string names, string? value, string help, string takes, Func<string, T?> read) : Option(names, value, help)
{
    public override string Takes => takes;

    public override object? Read(string text) => read(text);
}
