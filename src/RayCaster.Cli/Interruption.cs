namespace RayCaster.Cli;

internal static class Interruption
{
    private static readonly TimeSpan GracePeriod = TimeSpan.FromSeconds(0.5);

    /// <summary>Deletes unfinished files, and says in one line what was finished, and how to continue. Does not wait if standard error is a pipe
    /// that no program reads.</summary>
    public static void Tell(string[] arguments)
    {
        WrittenFiles.GiveUp();
        var command = Command.NameIn(arguments) is { } name ? Command.All[name] : null;
        var resumes = WrittenFiles.Count > 0 && command?.Takes(Option.Resume) == true;
        var end = command is LiveCommand ? "the page's server has stopped" : $"{WhatIsThere()}{(resumes ? "; --resume continues" : "")}";
        var telling = new Thread(() => StandardStreams.WriteError($"raycaster: interrupted; {end}")) { IsBackground = true };
        telling.Start();
        telling.Join(GracePeriod);
    }

    private static string WhatIsThere() => (WrittenFiles.Count, WrittenFiles.Last) switch
    {
        (0, _) when StandardStreams.HasOutput => "standard output is incomplete",
        (0, _) => "nothing was written",
        (1, var file) => $"{file} was written before",
        var (count, last) => $"{count} files were written before, the last is {last}",
    };
}
