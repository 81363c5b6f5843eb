using System.Net;
using System.Net.Sockets;

namespace RayCaster.Live.Tests;

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
}
