using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests;

/// <summary>The system calls of a command, by strace: no network, no other program, and only its own files written.</summary>
public sealed class SystemCallTests : CommandTests
{
    [Theory(Explicit = true, Skip = "Linux only", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("SCENES/mesh.json -s 60x40 -o new.png", "new.png")]
    [InlineData("models SCENES/mesh.json")]
    [InlineData("map SCENES/room.json t -s 60x40", "room.t.pfm", "room.t.png")]
    [InlineData("wrong SCENES/room.json rows -s 60x40", "room.rows.png")]
    [InlineData("part SCENES/room.json 0..9 -s 60x40 -o new.png", "new.png")]
    [InlineData("orbit SCENES/room.json --frames 2 -s 60x40", "room-0000.png", "room-0001.png")]
    [InlineData("compare a.png a.png -o new.png", "new.png")]
    [InlineData("stitch a.png -o new.png", "new.png")]
    [InlineData("vary SCENES/first.json --seed 1 -o new.json", "new.json")]
    [InlineData("diagnose SCENES/room.json a.png")]
    [InlineData("explain SCENES/room.json 3 3")]
    [InlineData("check SCENES/room.json")]
    [InlineData("mark rubric.json class -o marks", "marks")]
    [InlineData("handout lab1", "lab1")]
    public void NoNetworkNoOtherProgramAndNoOtherFile(string arguments, params string[] written)
    {
        raycaster.Run("part", Room, "0..39", "-s", "60x40", "-q", "-o", "a.png");
        raycaster.Write("rubric.json", $$"""
            { "title": "A room", "scenes": ["{{Room.Replace('\\', '/')}}"], "items": [ { "name": "all", "points": 1, "mistakes": ["rows"] } ] }
            """);
        Directory.CreateDirectory(raycaster.PathOf("class/anna"));
        foreach (var (file, text) in ((string, string)[])
            [("room.png", "no picture"), ("room.sh", "#!/bin/sh\ntouch executed\n"), ("results.xml", "")])
            raycaster.Write($"class/anna/{file}", text);
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

    /// <summary>The program as it is installed: outside of the clone, where handout would build the live page, which lies beside it.</summary>
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
