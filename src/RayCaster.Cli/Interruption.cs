namespace RayCaster.Cli;

/// <summary>Ends a run that a signal has interrupted.</summary>
internal static class Interruption
{
    private const int Patience = 500; // milliseconds

    /// <summary>Deletes unfinished files, and says in one line what was finished. Does not wait if standard error is a pipe that no program
    /// reads.</summary>
    public static void Tell()
    {
        WrittenFiles.GiveUp();
        var telling = new Thread(() => StandardFile.WriteError($"raycaster: interrupted; {WhatIsThere()}\n")) { IsBackground = true };
        telling.Start();
        telling.Join(Patience);
    }

    private static string WhatIsThere() => (WrittenFiles.Count, WrittenFiles.Last) switch
    {
        (0, _) when StandardFile.HasTakenBytes => "standard output is incomplete",
        (0, _) => "nothing was written",
        (1, var file) => $"{file} was written before",
        var (count, last) => $"{count} files were written before, the last is {last}",
    };
}
