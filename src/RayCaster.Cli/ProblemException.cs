namespace RayCaster.Cli;

/// <summary>An error that the user can fix. Only the message is printed.</summary>
internal sealed class ProblemException(string message) : Exception(message)
{
    /// <summary>A mistake on the command line; the message ends with the help command.</summary>
    public static ProblemException Usage(string problem) =>
        new($"raycaster: {problem}\nTry 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.");
}
