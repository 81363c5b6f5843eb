using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests;

/// <summary>The system calls of a command, by strace: no network, no other program, and only its own files written.</summary>
public sealed class SystemCallTests : CommandTests
{
    /// <summary>A command line of each command but the live page, and what it writes.</summary>
    public static readonly TheoryData<string, string[]> Commands = new()
    {
        { "SCENES/mesh.json -s 60x40 -o new.png", ["new.png"] },
        { "help models", [] },
        { "models SCENES/mesh.json", [] },
        { "map SCENES/room.json t -s 60x40", ["room.t.png"] },
        { "wrong SCENES/room.json rows -s 60x40", ["room.rows.png"] },
        { "part SCENES/room.json 0..9 -s 60x40 -o new.png", ["new.png"] },
        { "orbit SCENES/room.json --frames 2 -s 60x40", ["room-0000.png", "room-0001.png"] },
        { "compare a.png a.png -o new.png", ["new.png"] },
        { "stitch a.png -o new.png", ["new.png"] },
        { "vary SCENES/first.json --seed 1 -o new.json", ["new.json"] },
        { "diagnose SCENES/room.json a.png", [] },
        { "explain SCENES/room.json 3 3", [] },
        { "check SCENES/room.json", [] },
        { "mark rubric.json class -o marks", ["marks"] },
        { "handout lab1", ["lab1"] },
    };

    [Fact]
    public void EachCommandIsTried() => Assert.Equal(
        new CommandList().All.Select(command => command.Name).Except(["live", "draw"]).Order(),
        Commands.Select(row => row.Data.Item1.Split(' ')[0]).Where(word => word.All(char.IsAsciiLetter)).Order());

    [Theory(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [MemberData(nameof(Commands))]
    public void NoNetworkNoOtherProgramAndNoOtherFile(string arguments, string[] written)
    {
        PrepareInputs();
        // Without the runtime's own debugging socket, and its code in a file without a name.
        raycaster.RunInShell("command -v strace >/dev/null || exit 77; export DOTNET_EnableDiagnostics=0 DOTNET_EnableWriteXorExecute=0; " +
            $"strace -f -qq -o trace -e trace=%file,%network,%process '{Installed()}' {arguments.Replace("SCENES", RayCasterProcess.Scenes)}");
        Assert.SkipWhen(raycaster.ExitCode == 77, "strace is missing");
        Assert.Equal((0, ""), (raycaster.ExitCode / 2, Regex.Match(raycaster.Error, "^raycaster: .*").Value)); // 1 is an answer, too
        var trace = File.ReadAllText(raycaster.PathOf("trace"));
        Assert.Contains("openat(", trace);
        Assert.Single(Regex.Matches(trace, @"\bexecve\(")); // its own
        Assert.DoesNotMatch(@"\b(socket|connect|bind|sendto)\(", trace);
        string[] changed = // a call of one thread may be cut by another's: the rest of it, from "<unfinished", is on a later line
        [
            .. Regex.Matches(trace,
                    """openat\([^"\n]*"([^"\n]*)"[^)\n]*O_(?:WRONLY|RDWR|CREAT)|\b(?:mkdir|unlink|mknod\w*|symlink|link)\(.*?"([^"]*)["]""")
                .Select(call => call.Groups[1].Value + call.Groups[2].Value)
                .Where(path => !path.StartsWith("/proc/self/task/")) // the names of the threads
                // Of what is in its folder the file or folder there, by the name that it gets at the end.
                .Select(path => Regex.Replace(path, $@"^{Regex.Escape(raycaster.Folder)}/([^/]*?)(\.[0-9a-f]{{8}}\.tmp)?(/.*)?$", "$1"))
                .Distinct().Order(StringComparer.Ordinal),
        ];
        Assert.Equal(written, changed);
    }

    [Theory(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [MemberData(nameof(Commands))]
    public void NoProgramOfTheCurrentFolderIsExecuted(string arguments, string[] written)
    {
        PrepareInputs();
        PrepareTraps();
        foreach (var program in WaysToStart(RayCasterProcess.App))
        {
            Trace(program, arguments.Replace("SCENES", RayCasterProcess.Scenes));
            raycaster.RunInShell($"rm -r {string.Join(' ', written)}");
        }
    }

    /// <summary>The user's own xdg-open ends the page.</summary>
    [Theory(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("in the clone")]
    [InlineData("installed")]
    [InlineData("alone")]
    public void NorByTheLivePage(string how)
    {
        PrepareTraps();
        var built = Built("RayCaster.Live");
        if (how == "alone") Trace($"'{built}/raycaster-live'", "scene.json", ExitCode.Terminated);
        else
        {
            var app = how == "installed" ? Installed() : RayCasterProcess.App;
            if (how == "installed") raycaster.RunInShell($"cp '{built}'/raycaster-live.* '{built}/RayCaster.Page.dll' app");
            foreach (var program in WaysToStart(app)) Trace(program, "live scene.json", ExitCode.Terminated);
        }
    }

    [Fact(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void NorByTheLabThatShowsRightNumbers()
    {
        raycaster.Run("handout", "lab1", "--solution", "-q");
        raycaster.RunInShell("dotnet build lab1/src/Lab -v quiet");
        PrepareTraps();
        Trace("\"$PWD\"/lab1/src/Lab/bin/*/net10.0/Lab", "scene.json --pixel 3 3");
        var lab = $"'{Built("RayCaster.Lab")}/RayCaster.Lab'";
        Trace(lab, "scene.json --pixel 3 3");
        raycaster.RunInShell($"PATH=.:/nowhere {lab} scene.json --pixel 3 3");
        Assert.Equal((ExitCode.Failed, "dotnet is not in PATH: install it, or add its folder to PATH\n"), (raycaster.ExitCode, raycaster.Error));
    }

    private string Built(string project)
    {
        // Its folder, in which no global.json is a trap.
        raycaster.RunInShell($"cd '{ProjectFolder.PathOf($"src/{project}")}' && dotnet build -c Release -v quiet");
        return ProjectFolder.PathOf($"src/{project}/bin/Release/net10.0");
    }

    private static string[] WaysToStart(string app) => [$"'{app}'", $"\"$(command -v dotnet)\" '{app}.dll'"];

    /// <summary>Programs by the names of others, in a folder where a teacher might stand: in the current one, and so in each that PATH counts from
    /// it. A program that runs says so.</summary>
    private void PrepareTraps()
    {
        Directory.CreateDirectory(raycaster.PathOf("bin"));
        foreach (var name in (string[])["dotnet", "xdg-open", "open", "git", "bash", "python3", "gcc", "cc", "ld"])
            raycaster.Write(name, $"#!/bin/sh\necho {name} >>'{raycaster.PathOf("executed")}'\n");
        raycaster.Write("global.json", """{ "sdk": { "version": "99.0.100", "rollForward": "disable", "paths": ["sdk"] } }""");
        raycaster.Write("scene.json", File.ReadAllText(Path.Combine(RayCasterProcess.Scenes, "first.json")));
        raycaster.Write("bin/xdg-open", "#!/bin/sh\nkill -TERM $PPID\n"); // the user's own
        raycaster.RunInShell("chmod +x bin/* * 2>/dev/null");
    }

    /// <summary>Runs a program, which must not start one of the current folder.</summary>
    private void Trace(string program, string arguments, int exitCode = ExitCode.Done)
    {
        raycaster.RunInShell("command -v strace >/dev/null || exit 77; export DOTNET_EnableDiagnostics=0; " +
            $"strace -f -qq --seccomp-bpf -o trace -e trace=execve -E DISPLAY=:0 -E \"PATH=.::$PWD/bin:$PATH\" {program} {arguments}");
        Assert.SkipWhen(raycaster.ExitCode == 77, "strace is missing");
        Assert.False(File.Exists(raycaster.PathOf("executed")), $"{program} {arguments} executes {raycaster.PathOf("executed")}");
        Assert.Contains(raycaster.ExitCode, (int[])[exitCode, ExitCode.No]);
        Assert.Equal("", Regex.Match(raycaster.Error, "^raycaster: .*").Value);
        Assert.DoesNotMatch($@"execve\(""(?!/)|execve\(""{Regex.Escape(raycaster.Folder)}/[^/""]*""",
            File.ReadAllText(raycaster.PathOf("trace")));
    }

    private void PrepareInputs()
    {
        raycaster.Run("part", Room, "0..39", "-s", "60x40", "-q", "-o", "a.png");
        raycaster.Write("rubric.json", $$"""
            { "title": "A room", "scenes": ["{{Room.Replace('\\', '/')}}"], "items": [ { "name": "all", "points": 1, "mistakes": ["rows"] } ] }
            """);
        Directory.CreateDirectory(raycaster.PathOf("class/anna"));
        foreach (var (file, text) in ((string, string)[])
            [("room.png", "no picture"), ("room.sh", "#!/bin/sh\ntouch executed\n"), ("results.xml", "")])
            raycaster.Write($"class/anna/{file}", text);
    }

    /// <summary>The program as it is installed: outside of the clone, with the live page beside it.</summary>
    private string Installed()
    {
        var from = Path.GetDirectoryName(RayCasterProcess.App)!;
        foreach (var file in Directory.GetFiles(from, "*", SearchOption.AllDirectories))
        {
            var copy = raycaster.PathOf(Path.Combine("app", Path.GetRelativePath(from, file)));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
        foreach (var file in (string[])["raycaster-live.dll", "raycaster-live.runtimeconfig.json", "RayCaster.Page.dll"])
            raycaster.Write($"app/{file}", "");
        return raycaster.PathOf(Path.Combine("app", Path.GetFileName(RayCasterProcess.App)));
    }
}
