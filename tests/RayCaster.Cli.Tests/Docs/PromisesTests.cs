using System.Text.RegularExpressions;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Docs;

/// <summary>The figures of docs/limits.md are those of the code, and the sources keep SECURITY.md's promises about files, programs and
/// variables.</summary>
public class PromisesTests
{
    [Theory]
    [InlineData("67,108,864", SceneReader.MaxBytes)]
    [InlineData("268,435,456", MeshFile.MaxBytesAtOnce)]
    [InlineData("| threads | 1024,", Option.MaxThreads)]
    [InlineData("at most 4 per core are started", Option.MaxThreadsPerCore)]
    [InlineData("1000 are kept", SceneReading.MaxProblems)]
    [InlineData("20 are printed", SceneReading.Printed)]
    [InlineData("a scene file of n bytes | 4 MiB + 75 n", MemoryLimit.BytesOfScene)]
    [InlineData("each mesh file of n bytes | 4 MiB + 75 n", MemoryLimit.BytesOfMesh)]
    [InlineData("4 MiB + 10 n + 3 p + 64 w", MemoryLimit.BytesOfColumn)]
    [InlineData("+ 9 p", MemoryLimit.BytesOfPixelFromPipe)]
    public void TheLimitsAreThoseOfTheCode(string written, int limit)
    {
        Assert.Contains(written, Read("docs/limits.md"));
        Assert.Contains($"{limit}", Regex.Replace(written, @",|\b4 MiB", ""));
    }

    [Theory]
    [InlineData("1")]
    [InlineData("1024")]
    public void MoreThreadsThanAFewPerCoreAreNotStarted(string asked) => Assert.Equal(
        Math.Min(int.Parse(asked), 4 * Environment.ProcessorCount), CommandLine.Parse("draw", [Option.Threads], ["-t", asked]).Get(Option.Threads));

    [Fact]
    public void FilesAreWrittenInOnePlace() =>
        NowhereBut(
            ["RayCaster.Files/Platform/",
                "RayCaster.Marks/ClassMarks.cs", "RayCaster.Live/Browser.cs",
                "RayCaster.Web/Program.cs"], // in a browser, where files are in memory
            @"FileMode\.(Create|Append|OpenOrCreate|Truncate)|\bFile\.(Write|Append|Create|Delete|Move|Copy|Replace|OpenWrite|Set)"
            + @"|\bDirectory\.(Create|Delete|Move)|StreamWriter\(");

    /// <summary>The live page's promises have tests of their own.</summary>
    [Fact]
    public void NoNetworkAndNoForeignCode() =>
        NowhereBut(
            ["RayCaster.Live/", "RayCaster.Lab/Template/RightNumbers.cs"], // a student's own program, not raycaster
            @"System\.Net|HttpClient|Socket|DllImport|LibraryImport|Assembly\.Load");

    [Fact]
    public void ProgramsLinksAndFoldersAreFoundInOnePlace() =>
        NowhereBut(["RayCaster.Files/Platform/"], @"\bProcess\b|ProcessStartInfo|ResolveLinkTarget|GetFolderPath");

    [Fact]
    public void OneListSaysWhatMayFailOfAFile() =>
        NowhereBut(["RayCaster.Files/Platform/", "RayCaster.Files/ProblemException.cs"], "UnauthorizedAccessException");

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

    /// <param name="places">Where the pattern may be: files, or folders that end with a slash, below src.</param>
    private static void NowhereBut(string[] places, string pattern)
    {
        foreach (var path in SourceFiles())
        {
            var place = Path.GetRelativePath(ProjectFolder.PathOf("src"), path).Replace('\\', '/');
            if (!places.Any(allowed => place == allowed || (allowed.EndsWith('/') && place.StartsWith(allowed))))
                Assert.Equal((path, ""), (path, Regex.Match(File.ReadAllText(path), pattern).Value));
        }
    }

    private static IEnumerable<string> SourceFiles(string folder = "src") =>
        Directory.GetFiles(ProjectFolder.PathOf(folder), "*.cs", SearchOption.AllDirectories)
            .Where(path => !Regex.IsMatch(path, @"[/\\](obj|bin|HandOut[/\\]tests)[/\\]")); // these are the students' tests

    private static string Read(string file) => File.ReadAllText(ProjectFolder.PathOf(file)).ReplaceLineEndings("\n");
}
