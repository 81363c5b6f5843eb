using System.Net;
using System.Net.Sockets;
using System.Runtime.Versioning;

namespace RayCaster.Live.Tests;

/// <summary>The program's start: its port, and the secret in the page's address.</summary>
public class ProgramTests
{
    [Fact]
    public void ThePageHasThePortOfTheCommandLine()
    {
        using var folder = new TemporaryFolder();
        using var free = new TcpListener(IPAddress.Loopback, 0);
        free.Start();
        var port = ((IPEndPoint)free.LocalEndpoint).Port;
        free.Stop();
        using var live = LiveProcess.Start(folder.Write("scene.json", LivePage.Ball), options: $"--port={port}");
        Assert.StartsWith($"http://127.0.0.1:{port}/", live.Address);
    }

    /// <summary>Where the folder for such files is missing, as for a new account, the secret is not written into the current one.</summary>
    [Fact]
    public void TheSecretIsKeptInTheUsersFolderWhichIsMade()
    {
        using var folder = new TemporaryFolder();
        using var live = LiveProcess.Start(folder.Write("scene.json", LivePage.Ball), iteration: 1, home: folder["home/data"]);
        Assert.Contains(live.Address[(live.Address.IndexOf('=') + 1)..], File.ReadAllText(folder["home/data/raycaster-live"]));
    }

    /// <summary>The program that opens files writes its arguments and what it got: the secret must stand in a file of this user only.</summary>
    [Fact(Skip = "reads /proc", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here)), SupportedOSPlatform("linux")]
    public async Task TheSecretIsInNoProgramsArgumentsAndInFilesOfThisUserOnly()
    {
        using var folder = new TemporaryFolder();
        File.SetUnixFileMode(folder.Write("xdg-open", "#!/bin/sh\necho \"$@\" >\"$HOME/begun\"; stat -c %a \"$1\" >>\"$HOME/begun\"; "
            + "cat \"$1\" >>\"$HOME/begun\"; mv \"$HOME/begun\" \"$HOME/opened\"\n"), (UnixFileMode)0b111_101_101);
        File.SetUnixFileMode(folder.Write("raycaster-live", "an older address"), (UnixFileMode)0b110_110_110);
        using var live = LiveProcess.Start(folder.Write("scene.json", LivePage.Ball), iteration: 1, home: folder.Path, screen: folder.Path);
        var secret = live.Address[(live.Address.IndexOf('=') + 1)..];
        for (var i = 0; i < 6_000 && !File.Exists(folder["opened"]); i++) await Task.Delay(10);
        var opened = File.ReadAllLines(folder["opened"]);
        Assert.DoesNotContain(secret, opened[0]);
        Assert.Equal("600", opened[1]);
        Assert.Contains(live.Address, opened[2]);
        Assert.DoesNotContain(secret, File.ReadAllText($"/proc/{live.Id}/cmdline"));
        Assert.Contains(secret, File.ReadAllText(folder["raycaster-live"]));
        Assert.Equal((UnixFileMode)0b110_000_000, File.GetUnixFileMode(folder["raycaster-live"]));
        live.Send("TERM");
        await live.ExitCodeAsync();
        Assert.DoesNotContain(folder.Names, name => name.EndsWith(".html", StringComparison.Ordinal));
    }
}
