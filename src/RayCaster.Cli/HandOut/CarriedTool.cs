namespace RayCaster.Cli;

/// <summary>
/// This program in a hand-out: "dotnet lib/raycaster.dll diagnose", so that students need no clone of the repository, which has the solution. The
/// lab and its tests use its assemblies. It has no marks and makes no hand-outs.
/// </summary>
internal static class CarriedTool
{
    private static readonly string[] files =
    [
        "RayCaster.Library.dll", "RayCaster.Files.dll", "RayCaster.Engine.dll", "RayCaster.Teaching.dll", "raycaster.dll",
        "raycaster.runtimeconfig.json",
    ];

    private static readonly string[] page = [LiveProgram.Name, "raycaster-live.runtimeconfig.json", "RayCaster.Page.dll"];

    public static void Copy(string folder, CancellationToken cancellation)
    {
        Directory.CreateDirectory(folder);
        Copy(files, AppContext.BaseDirectory, folder);
        if (LiveProgram.Beside() is not null) Copy(page, AppContext.BaseDirectory, folder);
        else if (LiveProgram.Project() is { } project) CopyBuilt(project, folder, cancellation);
    }

    private static void Copy(string[] names, string from, string to)
    {
        foreach (var name in names)
        {
            if (!File.Exists(Path.Combine(from, name)))
                throw new ProblemException($"{name} is not beside this program, " +
                    "so it cannot be copied into a hand-out\n  Publish raycaster as separate files, not as one.");
            File.Copy(Path.Combine(from, name), Path.Combine(to, name));
        }
    }

    /// <summary>In a clone the live page may not be built, or not from what is there now.</summary>
    private static void CopyBuilt(string project, string folder, CancellationToken cancellation)
    {
        var built = Directory.CreateTempSubdirectory().FullName;
        var start = new ProcessStartInfo("dotnet", ["build", project, "-v", "quiet", "-tl:off", "-o", built, "-p:UseAppHost=false"])
        {
            RedirectStandardOutput = true, // even quietly it says that it has succeeded
            WorkingDirectory = project, // whose global.json says which SDK builds it
        };
        using var build = Process.Start(start)!;
        try
        {
            var said = build.StandardOutput.ReadToEndAsync(cancellation).GetAwaiter().GetResult();
            build.WaitForExit();
            if (build.ExitCode != 0) throw new ProblemException($"the live page cannot be built for the hand-out\n{said.Trim()}");
            Copy(page, built, folder);
        }
        finally
        {
            build.Kill(entireProcessTree: true); // where it was cancelled
            Directory.Delete(built, true);
        }
    }
}
