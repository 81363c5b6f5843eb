namespace RayCaster.Cli;

/// <summary>An error that the user can fix. Only the message is printed.</summary>
internal sealed class ProblemException(string message) : Exception(message)
{
    /// <summary>Whether the command line is wrong: then the command's usage is printed, too.</summary>
    public bool IsUsage { get; private init; }

    public static ProblemException Usage(string message) => new(message) { IsUsage = true };
}
