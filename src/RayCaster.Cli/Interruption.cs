namespace RayCaster.Cli;

/// <summary>The end of a run that a signal has interrupted.</summary>
internal static class Interruption
{
    private const int Patience = 500; // milliseconds

    /// <summary>Gives up what is not finished, and says in a line what is. Standard error may be a pipe that nobody reads: it does not wait for
    /// that.</summary>
    public static void Tell()
    {
        WrittenFiles.GiveUp();
        var telling = new Thread(() => StandardFile.WriteError($"raycaster: interrupted; {WhatIsThere()}\n")) { IsBackground = true };
        telling.Start();
        telling.Join(Patience);
    }

    private static string WhatIsThere() => (WrittenFiles.Count, WrittenFiles.Last) switch
    {
        (0, _) when StandardFile.HasTakenBytes => "what is in standard output is not whole",
        (0, _) => "nothing was written",
        (1, var file) => $"{file} was written before",
        var (count, last) => $"{count} files were written before, the last is {last}",
    };
}
