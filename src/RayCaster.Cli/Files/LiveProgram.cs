namespace RayCaster.Cli;

/// <summary>The live page's program.</summary>
internal static class LiveProgram
{
    public const string Name = "raycaster-live.dll";

    /// <summary>The folder that has it: this program's own if it was installed, and in a hand-out; in a clone it is built. Null if there is
    /// none.</summary>
    /// <exception cref="ProblemException">It does not build.</exception>
    public static string? Folder(CancellationToken cancellation) =>
        File.Exists(Path.Combine(AppContext.BaseDirectory, Name)) ? AppContext.BaseDirectory
        : Clone.Folder() is { } clone ? Programs.Build(Path.Combine(clone, "src", "RayCaster.Live"), cancellation) : null;
}
