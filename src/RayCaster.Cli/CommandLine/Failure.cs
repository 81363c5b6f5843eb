namespace RayCaster.Cli;

/// <summary>What keeps a command from being done, in words.</summary>
internal static class Failure
{
    /// <param name="hint">Printed after a wrong command line.</param>
    public static int Report(Exception e, string hint)
    {
        if (e is ReportedException) return ExitCode.Failed;
        if (Message(e) is { } message)
        {
            StandardStreams.WriteError($"raycaster: {message}");
            if (e is ProblemException { IsUsage: true }) StandardStreams.WriteError(hint);
            return ExitCode.Failed;
        }
        StandardStreams.WriteError($"""
            {Fault.InWords("raycaster", e)}
            With RAYCASTER_TRACE=1 it shows where it happened.
            """);
        if (Environment.GetEnvironmentVariable("RAYCASTER_TRACE") == "1") StandardStreams.WriteError($"{e}");
        return ExitCode.InternalError;
    }

    /// <summary>What to tell the user; null for a fault of this program.</summary>
    private static string? Message(Exception e) => e switch
    {
        ProblemException => e.Message,
        _ when ProblemException.IsCausedByFile(e) => IsCurrentFolderThere() ? e.Message : "the current folder was deleted",
        TypeInitializationException { InnerException: IOException } => // of the runtime's handling of signals
            "the system allows too few processes or open files: see ulimit -u and ulimit -n",
        _ => IsOutOfMemory(e) ? "there is not enough memory" : null,
    };

    private static bool IsCurrentFolderThere()
    {
        try
        {
            return Environment.CurrentDirectory.Length > 0;
        }
        catch (IOException)
        {
            return false;
        }
    }

    private static bool IsOutOfMemory(Exception? e) =>
        e is OutOfMemoryException || (e is AggregateException or TypeInitializationException && IsOutOfMemory(e.InnerException));
}

/// <summary>Ends a command whose errors are printed already.</summary>
internal sealed class ReportedException(string message) : Exception(message);
