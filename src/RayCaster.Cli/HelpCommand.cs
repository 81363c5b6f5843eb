namespace RayCaster.Cli;

internal sealed class HelpCommand : Command
{
    public override string Help => HelpText.Full;

    public override bool Takes(Option option) => false;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var name = line.Operands is [var first, ..] ? first : "help";
        if (!All.TryGetValue(name, out var command))
            throw ProblemException.Usage($"there is no command '{name}'{CommandLine.DidYouMean(name, All.Keys)}");
        StandardFile.WriteOutput(command().Help);
        return ExitCode.Done;
    }
}
