using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests;

/// <summary>The system calls of a command, by strace: no network, no other program, and only its own files written. Without strace the test does
/// nothing.</summary>
public sealed class SystemCallTests : CommandTests
{
    [Theory]
    [InlineData("SCENES/mesh.json -s 60x40 -o new.png", "new.png")]
    [InlineData("models SCENES/mesh.json")]
    [InlineData("orbit SCENES/room.json --frames 2 -s 60x40", "room-0000.png", "room-0001.png")]
    [InlineData("compare a.png a.png -o new.png", "new.png")]
    [InlineData("stitch a.png -o new.png", "new.png")]
    [InlineData("vary SCENES/first.json --seed 1 -o new.json", "new.json")]
    [InlineData("diagnose SCENES/room.json a.png")]
    [InlineData("explain SCENES/room.json 3 3")]
    [InlineData("check SCENES/room.json")]
    public void NoNetworkNoOtherProgramAndNoOtherFile(string arguments, params string[] written)
    {
        Assert.SkipWhen(!OperatingSystem.IsLinux(), "Linux only");
        raycaster.Run("part", Path.Combine(RayCasterProcess.Scenes, "room.json"), "0..39", "-s", "60x40", "-q", "-o", "a.png");
        // Without the runtime's own debugging socket, and its code in a file without a name.
        arguments = arguments.Replace("SCENES", RayCasterProcess.Scenes);
        raycaster.RunInShell("command -v strace >/dev/null || exit 77; export DOTNET_EnableDiagnostics=0 DOTNET_EnableWriteXorExecute=0; " +
            $"strace -f -qq -o trace -e trace=%file,%network,%process '{RayCasterProcess.App}' {arguments}");
        Assert.SkipWhen(raycaster.ExitCode == 77, "strace is missing");
        var trace = File.ReadAllText(raycaster.PathOf("trace"));
        Assert.Contains("openat(", trace);
        Assert.Single(Regex.Matches(trace, @"\bexecve\(")); // its own
        Assert.DoesNotMatch(@"\b(socket|connect|bind|sendto)\(", trace);
        string[] changed =
        [
            .. Regex.Matches(trace,
                    """openat\([^"]*"([^"]*)"[^)]*O_(?:WRONLY|RDWR|CREAT)|\b(?:mkdir|unlink|mknod\w*|symlink|link)\(.*?"([^"]*)["]""")
                .Select(call => call.Groups[1].Value + call.Groups[2].Value)
                .Where(path => !path.StartsWith("/proc/self/task/")) // the names of the threads
                .Distinct().Order(StringComparer.Ordinal),
        ];
        Assert.Equal(written, changed.Select(path => Regex.Replace(path, $@"^{Regex.Escape(raycaster.Folder)}/(.*)\.[0-9a-f]{{8}}\.tmp$", "$1")));
    }
}
