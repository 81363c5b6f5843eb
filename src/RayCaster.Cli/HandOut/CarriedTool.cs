using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>
/// This program in a hand-out: "dotnet lib/raycaster.dll diagnose", so that students need no clone of the repository, which has the solution. The
/// lab and its tests use its assemblies. It has no marks and makes no hand-outs.
/// </summary>
internal static partial class CarriedTool
{
    /// <summary>Those that the lab and the live page use, too.</summary>
    internal static readonly string[] Assemblies =
        ["RayCaster.Library.dll", "RayCaster.Files.dll", "RayCaster.Engine.dll", "RayCaster.Teaching.dll"];

    internal const string Page = "raycaster-live.dll";

    private static readonly string[] page = [Page, "raycaster-live.runtimeconfig.json", "RayCaster.Page.dll"];

    public static void Copy(string folder)
    {
        Copy(page, FolderOfPage(), folder);
        Copy([.. Assemblies, "raycaster.dll", "raycaster.runtimeconfig.json"], AppContext.BaseDirectory, folder);
    }

    /// <summary>The folder of the page's program: this one's if it was installed, and in a hand-out; in a clone that of its project, if it was built
    /// with the same assemblies.</summary>
    public static string FolderOfPage()
    {
        var here = Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory);
        if (File.Exists(Path.Join(here, Page))) return here;
        var (framework, configuration) = (Path.GetFileName(here), Path.GetFileName(Path.GetDirectoryName(here)));
        if (PathResolver.FolderWith("RayCaster.sln") is not { } clone)
            throw new ProblemException($"the live page is a program of its own, {Page}, which is not beside this one\n" +
                $"  In a clone of the project: dotnet run --project src/RayCaster.Live -- <scene>");
        var built = Path.Join(clone, "src", "RayCaster.Live", "bin", configuration, framework);
        if (File.Exists(Path.Join(built, Page)) && Array.TrueForAll(Assemblies, IsSame)) return built;
        throw new ProblemException($"the live page is a program of its own, which is not built with this one\n" +
            $"  Build it: dotnet build {Path.Join(clone, "src", "RayCaster.Live")} -c {configuration}");

        bool IsSame(string name) => File.Exists(Path.Join(built, name))
            && File.ReadAllBytes(Path.Join(built, name)).AsSpan().SequenceEqual(File.ReadAllBytes(Path.Join(here, name)));
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

    /// <summary>What is written in this hand-out, as "diagnose --done" calls it: a step is, when none of its bodies calls <c>Todo.Note</c> any
    /// more. None where there is no hand-out.</summary>
    public static string[] WrittenParts()
    {
        var lab = new DirectoryInfo(Path.Combine(AppContext.BaseDirectory, "..", "src", "Lab"));
        if (!lab.Exists) return [];
        var open = lab.EnumerateFiles("*.cs").SelectMany(file => Note().Matches(File.ReadAllText(file.FullName)))
            .Select(note => Slides.StepOf(note.Groups["slide"].Value)).ToHashSet();
        return [.. MissingPart.All.Where(part => !open.Contains(MissingPart.StepOf(part)))];
    }

    [GeneratedRegex(@"^\s*(return )?Todo\.Note\(""(?<slide>[^""]+)""", RegexOptions.Multiline)]
    private static partial Regex Note();
}
