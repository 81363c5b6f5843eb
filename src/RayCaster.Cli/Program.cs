namespace RayCaster.Cli;

internal static class Program
{
    private static readonly CommandList commands = new();

    internal static int Main(string[] arguments)
    {
        StandardStreams.UseUtf8();
        if (arguments.Length == 0)
        {
            StandardStreams.WriteError(HelpPage.FirstSteps);
            return ExitCode.Failed;
        }
        var command = commands.Find(arguments, out var words);
        try
        {
            return Interruption.Run(command, () => Run(command, words), e => Failure.Report(e, HelpPage.HintAfter(command)));
        }
        catch (Exception e) // of the handling of signals
        {
            return Failure.Report(e, "");
        }
    }

    private static int Run(Command command, string[] words)
    {
        if (command is DrawCommand) commands.ThrowIfMisspelled(words);
        var line = CommandLine.Parse(command.Name, [.. command.Options, Option.Help], words);
        if (line.Get(Option.Help))
            StandardStreams.WriteOutput(commands.HelpOf(command));
        else if (line.Get(Option.Version))
            StandardStreams.WriteOutput(typeof(Program).Assembly.GetName().Version!.ToString(3));
        else
            return command.Run(line);
        return ExitCode.Done;
    }
}
