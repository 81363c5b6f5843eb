namespace RayCaster.Cli;

/// <summary>Makes a scene of its own for each student.</summary>
internal sealed class VaryCommand : Command
{
    public override Option[] Options { get; } = [Option.Seed, Option.Output];

    public override string Help => "";

    public override int Run(CommandLine line, CancellationToken cancellation) => ExitCode.CouldNot;
}
