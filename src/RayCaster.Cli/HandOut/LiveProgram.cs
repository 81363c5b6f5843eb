namespace RayCaster.Cli;

/// <summary>The live page's program, which a hand-out carries along.</summary>
internal static class LiveProgram
{
    public const string Name = "raycaster-live.dll";

    /// <summary>Its file beside this program; null if it is not there.</summary>
    public static string? Beside() => Path.Combine(AppContext.BaseDirectory, Name) is var file && File.Exists(file) ? file : null;

    /// <summary>Its project in the clone that this program was built in; null outside of one.</summary>
    public static string? Project()
    {
        for (var parent = new DirectoryInfo(AppContext.BaseDirectory); parent is not null; parent = parent.Parent)
            if (Path.Combine(parent.FullName, "src", "RayCaster.Live") is var project && File.Exists(Path.Combine(project, "RayCaster.Live.csproj")))
                return project;
        return null;
    }
}
