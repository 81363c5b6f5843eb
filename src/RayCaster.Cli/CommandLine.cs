namespace RayCaster.Cli;

/// <summary>The parsed command line: a command, its operands and its options.</summary>
internal sealed class CommandLine
{
    private const int MaxThreadsPerCore = 4;

    private readonly Dictionary<Option, string> values = [];
    private readonly List<string> operands = [];

    public Command Command { get; private set; } = Command.All["draw"];

    /// <summary>The command's name; empty for drawing, which needs none.</summary>
    public string CommandName { get; private set; } = "";

    public IReadOnlyList<string> Operands => operands;

    /// <summary>The value of an option; null if it is not given.</summary>
    public string? this[Option option] => values.GetValueOrDefault(option);

    public bool Has(Option option) => values.ContainsKey(option);

    /// <summary>Prints a line about what was done, unless only errors are wanted.</summary>
    public void Tell(string text)
    {
        if (!Has(Option.Quiet)) StandardStreams.WriteError(text);
    }

    /// <summary>The warnings so far, for an answer in JSON; null if there are none.</summary>
    public string? Warning { get; private set; }

    /// <summary>Prints a warning about the answer, also if only errors are wanted.</summary>
    public void Warn(string text)
    {
        Warning = Warning is null ? text : $"{Warning} {text}";
        StandardStreams.WriteError(text);
    }

    public static CommandLine Parse(string[] arguments)
    {
        foreach (var word in arguments) FileWord.Check(word);
        var line = new CommandLine();
        for (var next = 0; next < arguments.Length;)
        {
            var word = arguments[next++];
            if (word == "--")
            {
                line.operands.AddRange(arguments.AsSpan(next));
                break;
            }
            if (word != "-" && word.StartsWith('-') && !IsNumber(word)) line.ReadOption(word, arguments, ref next);
            else if (line.operands.Count == 0 && line.CommandName == "" && Command.All.TryGetValue(word, out var command))
                (line.Command, line.CommandName) = (command, word);
            else
                line.operands.Add(word);
        }

        if (line.Has(Option.Help)) return line;
        if (line.operands.Contains("")) throw ProblemException.Usage("a name is empty: it names no file");
        foreach (var (option, _) in line.values)
            if (!line.Command.Takes(option))
                throw ProblemException.Usage(line.CommandName == ""
                    ? $"option '{option.Name}' belongs to a command: name the command"
                    : $"option '{option.Name}' is not one of {line.CommandName}'s");
        return line;
    }

    /// <summary>The operands of a command that needs exactly these.</summary>
    /// <param name="names">Their names, for the message if one is missing.</param>
    public IReadOnlyList<string> Exactly(params ReadOnlySpan<string> names)
    {
        if (operands.Count == names.Length) return operands;
        throw ProblemException.Usage(
            $"{CommandName} takes {string.Join(' ', names!)}, but {(operands.Count == 0 ? "nothing" : $"'{string.Join(' ', operands)}'")} is given");
    }

    /// <summary>How many threads; null for one per core. More than a few per core only need memory.</summary>
    public int? ThreadCount() =>
        Count(Option.Threads, "threads", 1024) is { } threads ? Math.Min(threads, MaxThreadsPerCore * Environment.ProcessorCount) : null;

    /// <summary>How long a search for mistakes may take; null for any time.</summary>
    public SearchBudget? Budget() => Has(Option.Everything) ? null : new(SearchBudget.Usual);

    /// <summary>A whole number from 1 to <paramref name="most"/>; null if the option is not given.</summary>
    /// <param name="what">What is counted, for the message if the value is no such number.</param>
    public int? Count(Option option, string what, int most) => this[option] is not { } text ? null
        : ParseCount(text) is { } count && count <= most ? count
        : throw ProblemException.Usage($"'{text}' is not a number of {what}: it is a whole number from 1 to {most:N0}");

    /// <summary>The lines of a picture that --rows names, or the frames of --only; all if the option is not given.</summary>
    /// <param name="option">Its value is <c>0..249</c> for the lines 0 to 249, both included, or <c>3/8</c> for the third of eight parts.</param>
    /// <param name="what">Their name in messages: lines or frames.</param>
    /// <param name="of">What has them, in messages: a picture or a film.</param>
    public LineRange Lines(Option option, int height, string what = "lines", string of = "a picture")
    {
        var whole = LineRange.Whole(height);
        if (this[option] is not { } text) return whole;
        if (text.Split('/') is [var k, var n] && ParseCount(k) is { } part && ParseCount(n) is { } parts && part <= parts)
        {
            if (parts > height) throw new ProblemException($"{of} of {height} {what} cannot be divided into {parts} parts");
            return new((int)((part - 1L) * height / parts), (int)((long)part * height / parts) - 1);
        }
        if (LineRange.Parse(text) is not { } lines)
            throw ProblemException.Usage(
                $"'{text}' names no {what}: write the first and the last as in 0..249, " +
                    $"counted from 0{(what == "lines" ? " at the top" : "")}, or 3/8 for the third of eight parts");
        if (lines.Last > whole.Last)
            throw new ProblemException($"the {what} {lines} do not all exist: {of} of {height} {what} has {whole}");
        return lines;
    }

    /// <summary>The picture's size; null for the scene's.</summary>
    public (int Width, int Height)? PictureSize()
    {
        if (this[Option.Size] is not { } text) return null;
        if (text.Split('x', 'X') is not [var w, var h] || ParseCount(w) is not { } width || ParseCount(h) is not { } height)
            throw ProblemException.Usage($"'{text}' is not a size: write width and height in pixels as in 640x480");
        if (width > Camera.MaxSide || height > Camera.MaxSide || (long)width * height > Camera.MaxPixels)
            throw ProblemException.Usage(
                $"'{text}' is too large: width and height are at most {Camera.MaxSide:N0}, their product at most {Camera.MaxPixels:N0}");
        return (width, height);
    }

    /// <summary>The picture format; null for the one of the file's extension.</summary>
    public PictureFormat? Format() => this[Option.Format] switch
    {
        null => null,
        "png" => PictureFormat.Png,
        "ppm" => PictureFormat.Ppm,
        "ppm-text" => PictureFormat.PpmText,
        var text => throw ProblemException.Usage($"'{text}' is not a format: choose png, ppm or ppm-text"),
    };

    /// <summary>The names in a list such as "plane,sphere" or "rows+bgr", each once; none if the option is not given.</summary>
    /// <param name="what">What a name stands for, in messages: "a mistake".</param>
    public string[] Names(Option option, char separator, IReadOnlyList<string> known, string what)
    {
        if (this[option] is not { } text) return [];
        var names = text.Split(separator, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (names.Length == 0) throw ProblemException.Usage($"the name of {what} is missing");
        if (Array.Find(names, name => !known.Contains(name)) is { } unknown)
            throw ProblemException.Usage($"'{unknown}' is not {what}; {HintFor(unknown)}");
        return [.. names.Distinct()];

        string HintFor(string name)
        {
            var other = separator == ',' ? '+' : ',';
            return name.Contains(other) ? $"join names by '{separator}', not by '{other}'"
                : Spelling.Nearest(name, known) is { } nearest ? $"did you mean '{nearest}'?"
                : known.Count < 10 ? $"choose {string.Join(", ", known)}" : "docs/mistakes.md lists them all";
        }
    }

    /// <summary>A whole number greater than 0; null for any other text.</summary>
    private static int? ParseCount(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var count) && count > 0 ? count : null;

    private void ReadOption(string word, string[] arguments, ref int next)
    {
        var (name, value) = word.StartsWith("--") && word.Split('=', 2) is [var left, var right] ? (left, right) : (word, null);
        if (Option.Named(name) is not { } option)
            throw ProblemException.Usage($"unknown option '{name}'{Spelling.DidYouMean(name, Option.All.Select(known => known.Name), quote: '\'')}");
        if (values.ContainsKey(option)) throw ProblemException.Usage($"option '{option.Name}' is given twice");
        if (!option.TakesValue && value is not null)
            throw ProblemException.Usage($"option '{option.Name}' takes no value, but '{value}' is given");
        if (option.TakesValue && value is null)
            value = next < arguments.Length ? arguments[next++] : throw ProblemException.Usage($"option '{option.Name}' needs a value");
        if (option.TakesValue && value!.Length == 0)
            throw ProblemException.Usage($"option '{option.Name}' needs a value, but an empty one is given");
        values[option] = value ?? "";
    }

    private static bool IsNumber(string word) => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
}
