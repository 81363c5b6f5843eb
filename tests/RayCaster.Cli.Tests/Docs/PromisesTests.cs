using System.Text.RegularExpressions;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Docs;

/// <summary>The figures of docs/limits.md are those of the code, and the sources keep SECURITY.md's promises about files, programs and
/// variables.</summary>
public class PromisesTests
{
    [Theory]
    [InlineData("67,108,864", SceneReader.MaxBytes)]
    [InlineData("threads | 1024", Option.MaxThreads)]
    [InlineData("268,435,456", MeshFile.MaxBytesAtOnce)]
    [InlineData("1000 are kept", SceneReading.MaxProblems)]
    [InlineData("20 are printed", SceneReading.Printed)]
    [InlineData("a scene file of n bytes | 4 MiB + 75 n", MemoryLimit.BytesOfScene)]
    [InlineData("each mesh file of n bytes | 4 MiB + 75 n", MemoryLimit.BytesOfMesh)]
    [InlineData("4 MiB + 10 n + 3 p + 64 w", MemoryLimit.BytesOfColumn)]
    [InlineData("+ 9 p", MemoryLimit.BytesOfPixelFromPipe)]
    public void TheLimitsAreThoseOfTheCode(string written, int limit)
    {
        Assert.Contains(written, Read("docs/limits.md"));
        Assert.Contains($"{limit}", Regex.Replace(written, @",|MiB|\b4 ", ""));
    }

    [Fact]
    public void ThreadsPerCoreAreThoseOfTheCode() =>
        Assert.Contains($"at most {(Option.MaxThreadsPerCore == 4 ? "four" : Option.MaxThreadsPerCore)} per core", Read("docs/limits.md"));

    [Fact]
    public void FilesAreWrittenInOnePlace() =>
        NowhereBut(
            ["WrittenFiles.cs", "HandOutFolder.cs", "CarriedTool.cs", "ClassMarks.cs", "PrivateFile.cs", "Browser.cs",
                "RayCaster.Web/Program.cs"], // in a browser, where files are in memory
            @"FileMode\.(Create|Append|OpenOrCreate|Truncate)|\bFile\.(Write|Append|Create|Delete|Move|Copy|Replace|OpenWrite|Set)"
            + @"|\bDirectory\.(Create|Delete|Move)|StreamWriter\(");

    [Fact]
    public void NoNetworkAndNoOtherProgram() =>
        NowhereBut([.. LivePage(), "LiveCommand.cs", "CarriedTool.cs"],
            @"System\.Net|HttpClient|Socket|Process\.Start|DllImport|LibraryImport|Assembly\.Load");

    [Fact]
    public void ThePageOfLimitsNamesEveryFileWithUncheckedAccess()
    {
        var page = Read("docs/limits.md");
        var unsafeFiles = SourceFiles().Where(path => Regex.IsMatch(File.ReadAllText(path),
            @"\bUnsafe\.|LoadUnsafe|StoreUnsafe|\bunsafe\b|GetArrayDataReference|GetReference\(|\bRawSpan\b"));
        Assert.All(unsafeFiles, path => Assert.Contains($"/{Path.GetFileName(path)}`", page));
    }

    [Fact]
    public void OnlyNamedVariablesAreRead()
    {
        NowhereBut([], @"EnvironmentVariables|EnvironmentVariable\((?!"")");
        foreach (var path in SourceFiles())
            foreach (Match variable in Regex.Matches(File.ReadAllText(path), @"(?:[vV]ariable|Has)\(""([A-Z_]+)"""))
                Assert.Contains($"`{variable.Groups[1].Value}`", Read("SECURITY.md"));
    }

    /// <summary>The sources of the live page, whose promises have tests of their own.</summary>
    private static IEnumerable<string> LivePage() =>
        SourceFiles().Where(path => path.Contains($"{Path.DirectorySeparatorChar}RayCaster.Live{Path.DirectorySeparatorChar}"))
            .Select(path => Path.GetFileName(path));

    private static void NowhereBut(string[] files, string pattern)
    {
        foreach (var path in SourceFiles())
            if (!files.Any(file => path.Replace('\\', '/').EndsWith($"/{file}", StringComparison.Ordinal)))
                Assert.Equal((path, ""), (path, Regex.Match(File.ReadAllText(path), pattern).Value));
    }

    private static IEnumerable<string> SourceFiles(string folder = "src") =>
        Directory.GetFiles(ProjectFolder.PathOf(folder), "*.cs", SearchOption.AllDirectories)
            .Where(path => !Regex.IsMatch(path, @"[/\\](obj|bin)[/\\]"));

    private static string Read(string file) => File.ReadAllText(ProjectFolder.PathOf(file)).ReplaceLineEndings("\n");
}
