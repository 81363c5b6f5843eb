namespace RayCaster.Cli;

/// <summary>The words behind a command's name: its operands and its options.</summary>
internal sealed class CommandLine(string command)
{
    private readonly Dictionary<Option, object> values = [];
    private readonly List<string> operands = [];

    public IReadOnlyList<string> Operands => operands;

    public string[] Words { get; private init; } = [];

    /// <summary>The warnings so far, for an answer in JSON; null if there are none.</summary>
    public string? Warning { get; private set; }

    public static CommandLine Parse(string command, Option[] options, ReadOnlySpan<string> words)
    {
        foreach (var word in words) RefuseInvisible(word);
        var line = new CommandLine(command) { Words = words.ToArray() };
        while (words is [var word, .. var rest])
        {
            words = rest;
            if (word == "--")
            {
                line.operands.AddRange(rest);
                break;
            }
            if (word != "-" && word.StartsWith('-') && !IsNumber(word)) line.Add(word, options, ref words);
            else line.operands.Add(word);
        }
        line.RefuseTornLists();
        return line.operands.Contains("") ? throw ProblemException.Usage("a name is empty: it names no file") : line;
    }

    /// <summary>The value of an option; null, or false for a switch, if it is not given.</summary>
    public T? Get<T>(Option<T> option) => values.TryGetValue(option, out var value) ? (T)value : default;

    /// <summary>The operands of a command that needs exactly these.</summary>
    /// <param name="names">Their names, for the message if one is missing.</param>
    public IReadOnlyList<string> Exactly(params ReadOnlySpan<string> names)
    {
        if (operands.Count == names.Length) return operands;
        throw ProblemException.Usage(
            $"{command} takes {string.Join(' ', names!)}, but {(operands.Count == 0 ? "nothing" : $"'{string.Join(' ', operands)}'")} is given");
    }

    /// <summary>How much a search for mistakes may do; null for any amount.</summary>
    public SearchBudget? Budget() => Get(Option.Everything) ? null : new();

    public void Tell(string text)
    {
        if (!Get(Option.Quiet)) StandardStreams.WriteError(text);
    }

    /// <summary>Prints a warning about the answer, also if only errors are wanted.</summary>
    public void Warn(string text)
    {
        Warning = Warning is null ? text : $"{Warning} {text}";
        StandardStreams.WriteError(text);
    }

    /// <summary>
    /// Refuses dangerous characters in file names and other words of messages. A line end could forge a line of output, and a direction mark could
    /// show a name in reverse. A name that is not UTF-8 arrives here as the name of another file, which does not exist.
    /// </summary>
    public static void RefuseInvisible(string word)
    {
        if (word.Contains('\uFFFD')) throw new ProblemException($"the name '{PrintableText.From(word)}' is not UTF-8: rename the file");
        foreach (var c in word)
            if (!PrintableText.IsPrintable(c))
                throw new ProblemException($"'{PrintableText.From(word)}' holds the invisible character U+{(int)c:X4}: rename the file, " +
                    "or type the name again if it was copied");
    }

    /// <summary>Refuses a list with blanks in it: the words after the first one look like operands.</summary>
    private void RefuseTornLists()
    {
        foreach (var (option, value) in values)
        {
            string[] torn = [.. operands.Where(word => !File.Exists(word) && Spelling.Nearest(word.Trim(','), option.Known) is not null)];
            if (torn.Length > 0)
                throw ProblemException.Usage($"'{string.Join(' ', torn)}' seems to belong to the list of {option.Name}: write {option.Name} " +
                    $"{string.Join(',', ((string[])value).Concat(torn.Select(word => word.Trim(','))))}, without blanks (in PowerShell in quotes)");
        }
    }

    /// <summary>Adds an option, <c>--name value</c> or <c>--name=value</c>.</summary>
    private void Add(string word, Option[] options, ref ReadOnlySpan<string> rest)
    {
        var (name, value) = word.StartsWith("--") && word.Split('=', 2) is [var left, var right] ? (left, right) : (word, null);
        if (options.FirstOrDefault(known => known.Names.Contains(name)) is not { } option)
            throw ProblemException.Usage($"unknown option '{name}'{Spelling.DidYouMean(name, options.Select(known => known.Name), quote: '\'')}");
        if (values.ContainsKey(option)) throw ProblemException.Usage($"option '{option.Name}' is given twice");
        if (!option.TakesValue && value is not null)
            throw ProblemException.Usage($"option '{option.Name}' takes no value, but '{value}' is given");
        if (option.TakesValue && value is null)
        {
            if (rest.IsEmpty) throw ProblemException.Usage($"option '{option.Name}' needs a value");
            value = rest[0];
            rest = rest[1..];
        }
        if (value == "") throw ProblemException.Usage($"option '{option.Name}' needs a value, but an empty one is given");
        values[option] = option.Read(value ?? "")
            ?? throw ProblemException.Usage($"option '{option.Name}' takes {option.Takes}, but '{value}' is given");
    }

    private static bool IsNumber(string word) => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
}
