namespace RayCaster.Cli;

/// <summary>The live page's program, which lies beside this one if it was installed, and in a hand-out.</summary>
internal static class LiveProgram
{
    public const string Name = "raycaster-live.dll";

    /// <summary>Its file beside this program; null if it is not there.</summary>
    public static string? Beside()
    {
        var file = Path.Combine(AppContext.BaseDirectory, Name);
        return File.Exists(file) ? file : null;
    }

    /// <summary>Its project in a clone; null outside of one.</summary>
    public static string? Project() => Clone.Folder() is { } clone ? Path.Combine(clone, "src", "RayCaster.Live") : null;
}
