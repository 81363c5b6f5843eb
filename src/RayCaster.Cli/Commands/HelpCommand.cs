namespace RayCaster.Cli;

internal sealed class HelpCommand : Command
{
    /// <summary>Shown without arguments: the one command to try.</summary>
    public const string Usage = """
        raycaster draws a scene: it casts one ray for each pixel and writes the picture.
        Try:   dotnet run --project src/RayCaster.Cli -- scenes/first.json
        More:  dotnet run --project src/RayCaster.Cli -- help
        """;

    public override string Help => All["draw"].Help;

    public override bool Takes(Option option) => false;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var name = line.Operands is [var first, ..] ? first : "help";
        if (!All.TryGetValue(name, out var command))
            throw ProblemException.Usage($"there is no command '{name}'{Spelling.DidYouMean(name, All.Keys, quote: '\'')}");
        StandardStreams.WriteOutput(command.Help);
        return ExitCode.Done;
    }

    /// <summary>Shown after a wrong command line: the usage of its command, and how to read more.</summary>
    public static string HintAfter(string[] arguments)
    {
        if (NameIn(arguments) is not { } name) return "Try 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.\n";
        var help = All[name].Help;
        var usage = help.AsSpan(help.IndexOf("Usage:", StringComparison.Ordinal));
        return $"{usage[..usage.IndexOf("\n\n")]}\nTry 'raycaster help {name}', or dotnet run --project src/RayCaster.Cli -- help {name}.\n";
    }
}
