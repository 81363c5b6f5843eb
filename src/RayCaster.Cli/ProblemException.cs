namespace RayCaster.Cli;

/// <summary>Something that the user can mend; the message is all that is printed.</summary>
internal sealed class ProblemException(string message) : Exception(message)
{
    /// <summary>A mistake on the command line, with where to look it up.</summary>
    public static ProblemException Usage(string problem) =>
        new($"raycaster: {problem}\nTry 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.");
}
