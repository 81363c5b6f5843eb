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

    private static readonly string[] page = [LiveCommand.Program, "raycaster-live.runtimeconfig.json", "RayCaster.Page.dll"];

    public static void Copy(string folder)
    {
        Copy(files, AppContext.BaseDirectory, folder);
        if (LiveCommand.ProgramFolder() is { } live) Copy(page, live, folder);
    }

    private static void Copy(string[] names, string from, string to)
    {
        foreach (var name in names)
        {
            if (!File.Exists(Path.Combine(from, name)))
                throw new ProblemException($"{name} is not beside this program, " +
                    "so it cannot be copied into a hand-out\n  Publish raycaster as separate files, not as one.");
            WrittenFiles.Put(Path.Combine(to, name), File.ReadAllBytes(Path.Combine(from, name)));
        }
    }
}
