using System.Diagnostics;

namespace RayCaster.Cli.Tests.HandOut;

/// <summary>
/// A hand-out, or a clone of this project, in a folder of somebody's repository. What the SDK reads from the folders above a project would break the
/// build: each of these files does so where it is read.
/// </summary>
public sealed class ForeignRepositoryTests : CommandTests
{
    private const string Folder = "O'Malley, Ann [1] 100% ü";

    public ForeignRepositoryTests()
    {
        Directory.CreateDirectory(raycaster.PathOf($"{Folder}/.config"));
        foreach (var (file, text) in ((string, string)[])[
            ("Directory.Build.props", "no XML"),
            ("Directory.Build.targets", "no XML"),
            ("Directory.Packages.props", "no XML"),
            ("Directory.Solution.props", "no XML"),
            ("Directory.Solution.targets", "no XML"),
            ("nuget.config", "no XML"),
            ("Directory.Build.rsp", "-nonsense"),
            ("MSBuild.rsp", "-nonsense"),
            ("global.json", """{ "sdk": { "version": "99.0.100", "rollForward": "disable" } }"""),
            (".editorconfig", "[*.cs]\ndotnet_diagnostic.CA1051.severity = error\n"), // a field that everybody sees, as in the lab
            (".globalconfig", "is_global = true\ndotnet_diagnostic.CA1051.severity = error\n"),
            ("dotnet-tools.json", "no JSON"),
            (".config/dotnet-tools.json", "no JSON"),
            ("dotnet.config", "no configuration"),
            (".runsettings", "no XML"),
            ("testconfig.json", "no JSON"),
            ("xunit.runner.json", "no JSON"),
            (".git", "gitdir: /nowhere")])
            raycaster.Write($"{Folder}/{file}", text);
    }

    [Fact(Explicit = true)]
    public void AHandOutBuildsDrawsAndTestsThere()
    {
        raycaster.Run("handout", "-q", "--solution", $"{Folder}/lab");
        DotnetDoes("lab", "build -warnaserror");
        DotnetDoes("lab", "run --no-build --project src/Lab -- scenes/room.json room.png");
        Assert.Equal(0, raycaster.Run("compare", $"{Folder}/lab/room.png", $"{Folder}/lab/scenes/step10/room.png", "--scene", Room).ExitCode);
        DotnetDoes("lab", "test --no-build");
    }

    [Fact(Explicit = true)]
    public void ACloneBuildsDrawsTestsAndHandsOutThere()
    {
        using var git = Process.Start(new ProcessStartInfo("git", ["ls-files", "-z", "-co", "--exclude-standard"])
        {
            WorkingDirectory = ProjectFolder.Root,
            RedirectStandardOutput = true,
        })!;
        foreach (var file in git.StandardOutput.ReadToEnd().Split('\0', StringSplitOptions.RemoveEmptyEntries))
        {
            if (!File.Exists(ProjectFolder.PathOf(file))) continue; // deleted since the last commit
            var copy = raycaster.PathOf($"{Folder}/clone/{file}");
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(ProjectFolder.PathOf(file), copy);
        }
        DotnetDoes("clone", "restore -warnaserror"); // of the solution
        DotnetDoes("clone", "run --project src/RayCaster.Cli -- scenes/room.json -q");
        Assert.Equal(PictureFile.Read(ProjectFolder.PathOf("docs/room.png")).Rgb,
            PictureFile.Read(raycaster.PathOf($"{Folder}/clone/room.png")).Rgb);
        DotnetDoes("clone", "test --project tests/RayCaster.Lab.Tests -c Release");
        DotnetDoes("clone", "build src/RayCaster.Live -c Release"); // a hand-out has the live page, and no command compiles
        DotnetDoes(".", "clone/src/RayCaster.Cli/bin/Release/net10.0/raycaster.dll handout -q lab");
    }

    private void DotnetDoes(string folder, string command)
    {
        using var dotnet = Process.Start(new ProcessStartInfo("dotnet", command.Split(' '))
        {
            WorkingDirectory = raycaster.PathOf($"{Folder}/{folder}"),
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        })!;
        var error = dotnet.StandardError.ReadToEndAsync();
        var output = dotnet.StandardOutput.ReadToEnd();
        dotnet.WaitForExit();
        Assert.True(dotnet.ExitCode == 0, $"dotnet {command}: {output}{error.Result}");
    }
}
