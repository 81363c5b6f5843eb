namespace RayCaster.Cli;

/// <summary>
/// This program in a hand-out: "dotnet lib/raycaster.dll diagnose", so that students need no clone of the repository, which has the solution. The
/// lab and its tests use its assemblies. It has no marks and makes no hand-outs.
/// </summary>
internal static class CarriedTool
{
    /// <summary>Those that the lab and the live page use, too.</summary>
    internal static readonly string[] Assemblies =
        ["RayCaster.Library.dll", "RayCaster.Files.dll", "RayCaster.Engine.dll", "RayCaster.Teaching.dll"];

    private static readonly string[] page = [LiveCommand.Program, "raycaster-live.runtimeconfig.json", "RayCaster.Page.dll"];

    public static void Copy(string folder)
    {
        Copy(page, LiveCommand.ProgramFolder(), folder);
        Copy([.. Assemblies, "raycaster.dll", "raycaster.runtimeconfig.json"], AppContext.BaseDirectory, folder);
    }

    private static void Copy(string[] names, string from, string to)
    {
        foreach (var name in names)
        {
            if (!File.Exists(Path.Combine(from, name)))
                throw new ProblemException($"{name} is not beside this program, " +
                    "so it cannot be copied into a hand-out\n  Publish raycaster as separate files, not as one.");
            AtomicFile.WriteInFolder(Path.Combine(to, name), File.ReadAllBytes(Path.Combine(from, name)));
        }
    }
}
