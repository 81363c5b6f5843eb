using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;

namespace RayCaster.Live;

/// <summary>Serves the page on this machine, and on no other.</summary>
internal sealed class LiveServer : IAsyncDisposable
{
    /// <summary>More pages than anybody opens; each costs two pictures.</summary>
    private const int MostTabs = 64;

    private readonly ConcurrentDictionary<Tab, byte> tabs = new();
    private readonly PageFiles files = new();
    private readonly CancellationTokenSource end = new();
    private readonly Gate gate;
    private readonly WebApplication app;
    private byte[]? errors; // what the pages were told last of the code
    private int warmed;

    private LiveServer(LiveScene scene, MinePicture mine, int port, bool hasVersion6)
    {
        (Scene, Mine, Port) = (scene, mine, port);
        gate = new(port, WatchLine.Secret is { } secret ? Convert.ToHexStringLower(secret) : Gate.NewToken());
        var builder = WebApplication.CreateEmptyBuilder(new());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxRequestBodySize = 0;
            kestrel.Listen(IPAddress.Loopback, port);
            if (hasVersion6) kestrel.Listen(IPAddress.IPv6Loopback, port);
        });
        app = builder.Build();
        app.UseWebSockets(new() { KeepAliveInterval = TimeSpan.FromSeconds(10), KeepAliveTimeout = TimeSpan.FromSeconds(20) });
        app.Run(AnswerAsync);
        Scene.Changed += WakeAll;
        Mine.Changed += LookAtMine;
    }

    /// <summary>The scene that is shown.</summary>
    public LiveScene Scene { get; }

    /// <summary>The picture that it is compared with.</summary>
    public MinePicture Mine { get; }

    /// <summary>Draws.</summary>
    public Studio Studio { get; } = new();

    /// <summary>Where the page is.</summary>
    public int Port { get; }

    /// <summary>The page's address, with its secret.</summary>
    public string Address => gate.Address;

    /// <summary>Starts to serve.</summary>
    /// <param name="options">What the command line says.</param>
    /// <exception cref="ProblemException">The port is taken.</exception>
    public static async Task<LiveServer> StartAsync(LiveOptions options)
    {
        var (port, hasVersion6) = WatchLine.Secret is [var high, var low, ..] && options.Port == 0
            ? TryPort(49152 + (high << 8 | low) % 16384) ?? FreePort(0) // the same after a restart, so that open pages find it
            : FreePort(options.Port);
        var server = new LiveServer(new(options.Scene), new(options.Mine), port, hasVersion6);
        try
        {
            await server.app.StartAsync();
        }
        catch (IOException)
        {
            throw new ProblemException($"raycaster-live: port {port} is taken; choose another, or leave --port out");
        }
        _ = server.Scene.FollowAsync();
        _ = server.Mine.FollowAsync();
        _ = WatchLine.FollowAsync(server.TellErrors, server.end.Token);
        return server;
    }

    /// <summary>Prepares for a camera that moves, once there is something to look at.</summary>
    public void FirstPictureSent(Scene scene)
    {
        if (Interlocked.Exchange(ref warmed, 1) == 0) Studio.WarmUp(scene);
    }

    public async ValueTask DisposeAsync()
    {
        await end.CancelAsync();
        Scene.Dispose();
        Mine.Dispose();
        await app.DisposeAsync();
    }

    private static (int Port, bool HasVersion6)? TryPort(int wanted)
    {
        try
        {
            return FreePort(wanted);
        }
        catch (ProblemException)
        {
            return null;
        }
    }

    /// <summary>A port that is free on both of the machine's own addresses; without version 6 of the protocol on one.</summary>
    private static (int Port, bool HasVersion6) FreePort(int wanted)
    {
        for (var attempt = 0; ; attempt++)
        {
            try
            {
                using var first = new TcpListener(IPAddress.Loopback, wanted);
                first.Start();
                var port = ((IPEndPoint)first.LocalEndpoint).Port;
                if (!Socket.OSSupportsIPv6) return (port, false);
                try
                {
                    using var second = new TcpListener(IPAddress.IPv6Loopback, port);
                    second.Start();
                    return (port, true);
                }
                catch (SocketException e) when (e.SocketErrorCode == SocketError.AddressNotAvailable)
                {
                    return (port, false); // switched off on this machine
                }
            }
            catch (SocketException) when (wanted == 0 && attempt < 10)
            {
                // Free on one address and taken on the other: another one.
            }
            catch (SocketException e)
            {
                throw new ProblemException(e.SocketErrorCode == SocketError.AccessDenied
                    ? $"raycaster-live: port {wanted} is the system's; choose one above 1023"
                    : $"raycaster-live: port {wanted} is taken; choose another, or leave --port out");
            }
        }
    }

    private async Task AnswerAsync(HttpContext context)
    {
        if (gate.Refuse(context) is { } reason) await SayAsync(context, StatusCodes.Status403Forbidden, reason);
        else if (context.Request.Path == "/live" && context.WebSockets.IsWebSocketRequest) await ServeTabAsync(context);
        else if (context.Request.Path == "/mine" && HttpMethods.IsPost(context.Request.Method)) await TakeMineAsync(context);
        else if (!HttpMethods.IsGet(context.Request.Method))
            await SayAsync(context, StatusCodes.Status405MethodNotAllowed, "This is not to be done here.");
        else if (!await files.TryAnswerAsync(context)) await SayAsync(context, StatusCodes.Status404NotFound, "There is nothing of this name.");
    }

    private static Task SayAsync(HttpContext context, int status, string reason)
    {
        context.Response.StatusCode = status;
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync(reason + "\n");
    }

    private async Task ServeTabAsync(HttpContext context)
    {
        if (tabs.Count >= MostTabs)
        {
            await SayAsync(context, StatusCodes.Status503ServiceUnavailable, $"There are {MostTabs} pages open already; close some.");
            return;
        }
        using var socket = await context.WebSockets.AcceptWebSocketAsync();
        var tab = new Tab(socket, this, end.Token);
        tabs.TryAdd(tab, 0);
        if (errors is { } known) tab.Post(known);
        try
        {
            await tab.RunAsync();
        }
        finally
        {
            tabs.TryRemove(tab, out _);
        }
    }

    /// <summary>Takes a picture of the user's own program, of the scene's size at most.</summary>
    private async Task TakeMineAsync(HttpContext context)
    {
        var camera = Scene.State.Scene?.Camera;
        var pixels = Math.Min(View.MostPixels, (long)(camera?.Width ?? 0) * (camera?.Height ?? 0));
        // Four digits for each of three numbers is the longest form there is, a PPM in readable numbers; a little more for comments.
        context.Features.Get<IHttpMaxRequestBodySizeFeature>()!.MaxRequestBodySize = 12 * pixels + 65_536;
        try
        {
            using var bytes = new MemoryStream();
            await context.Request.Body.CopyToAsync(bytes, context.RequestAborted);
            bytes.Position = 0;
            Mine.Take(NameOf(context.Request.Query["name"].ToString()), bytes, Math.Max(1, pixels));
            context.Response.StatusCode = StatusCodes.Status204NoContent;
        }
        catch (BadHttpRequestException e)
        {
            await SayAsync(context, e.StatusCode, "The file is larger than any picture of this scene's size.");
        }
        catch (PictureFileException e)
        {
            await SayAsync(context, StatusCodes.Status422UnprocessableEntity, e.Message);
        }
    }

    /// <summary>What a dropped file is called, without what could be more than a name.</summary>
    private static string NameOf(string text)
    {
        var name = string.Concat(Path.GetFileName(text.Replace('\\', '/')).Where(c => !char.IsControl(c)));
        return name.Length == 0 ? "your picture" : name[..Math.Min(100, name.Length)];
    }

    /// <summary>Tells all pages what keeps the code from being built.</summary>
    internal void TellErrors(IReadOnlyList<CodeError> found)
    {
        errors = Messages.OfCode(found);
        foreach (var tab in tabs.Keys) tab.Post(errors);
    }

    private void WakeAll()
    {
        foreach (var tab in tabs.Keys) tab.Wake();
    }

    private void LookAtMine()
    {
        foreach (var tab in tabs.Keys) tab.LookAtMine();
    }
}
