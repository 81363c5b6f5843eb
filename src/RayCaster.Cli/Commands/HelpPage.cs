namespace RayCaster.Cli;

/// <summary>The help pages, printed from what the commands declare.</summary>
internal static class HelpPage
{
    /// <summary>Shown without arguments: the one command to try.</summary>
    public const string FirstSteps = """
        raycaster draws a scene: it casts one ray for each pixel and writes the picture.
        Try:   dotnet run --project src/RayCaster.Cli -- scenes/first.json
        More:  dotnet run --project src/RayCaster.Cli -- help
        """;

    private const int Width = 90;

    /// <param name="groups">Other commands to list, in groups with a title.</param>
    public static string Format(Command command, params IEnumerable<(string Title, Command[] Commands)> groups)
    {
        var lists = groups.Select(group => Table(group.Title, group.Commands.Select(other => ($"{other.Name} {other.Operands}", other.Summary))));
        var options = command.Options.Append(Option.Help).Select(option => (option.Usage, option.HelpText));
        var examples = command.Examples.Select(example => "\n  raycaster " + example);
        return string.Join("\n\n", (string[])
        [
            Paragraph("Description", command.Description), Usage(command), .. lists,
            Table("Arguments", command.Arguments), Table("Options", options),
            "Examples, where raycaster is \"dotnet run --project src/RayCaster.Cli --\":" + string.Concat(examples),
            Paragraph("Exit codes", command.ExitCodes),
        ]) + "\n";
    }

    /// <summary>Shown after a wrong command line: the usage of its command, and how to read more.</summary>
    public static string HintAfter(Command command)
    {
        if (command is DrawCommand or HelpCommand) return "Try 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.";
        return $"{Usage(command)}\nTry 'raycaster help {command.Name}', or dotnet run --project src/RayCaster.Cli -- help {command.Name}.";
    }

    private static string Usage(Command command) => command is DrawCommand
        ? "Usage:\n  raycaster [draw] <scene> [options]\n  raycaster <command> ...\n  raycaster help [command]"
        : $"Usage:\n  raycaster {command.Name} {command.Operands} [options]";

    private static string Paragraph(string title, string text) =>
        $"{title}:" + string.Concat(Wrapped(text, Width - 2).Select(line => "\n  " + line));

    private static string Table(string title, IEnumerable<(string Name, string Text)> rows)
    {
        var indent = rows.Max(row => row.Name.Length) + 4;
        var lines = rows.Select(row => $"  {row.Name}".PadRight(indent) +
            string.Join("\n" + new string(' ', indent), Wrapped(row.Text, Width - indent)));
        return $"{title}:\n{string.Join('\n', lines)}";
    }

    private static List<string> Wrapped(string text, int width)
    {
        var lines = new List<string> { "" };
        foreach (var word in text.Split(' '))
            if (lines[^1] == "") lines[^1] = word;
            else if (lines[^1].Length + 1 + word.Length <= width) lines[^1] += " " + word;
            else lines.Add(word);
        return lines;
    }
}
