using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.Extensions.FileProviders;

namespace RayCaster.Live;

/// <summary>Serves the page on this machine's own addresses only.</summary>
internal sealed class LiveServer : IAsyncDisposable
{
    /// <summary>How many pages may be open at once; each takes the memory of two pictures.</summary>
    private const int MaxTabs = 64;

    private const int MaxConnections = 4 * MaxTabs;

    /// <summary>How many free ports are tried: a port that is free for IPv4 may be taken for IPv6.</summary>
    private const int MaxAttempts = 10;

    private readonly ConcurrentDictionary<PageSession, byte> sessions = new();
    private readonly CancellationTokenSource end = new();
    private readonly RequestGuard guard;
    private readonly WebApplication app;

    private LiveServer(string scene, string? mine, PageAddress address, TimeProvider clock, TimeSpan silence)
    {
        Scene = new(scene, clock, end.Token);
        Mine = new(mine, clock, end.Token);
        Port = address.Port;
        guard = new(Port, address.Token);
        var builder = WebApplication.CreateEmptyBuilder(new());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxRequestBodySize = 0;
            kestrel.Limits.MaxConcurrentConnections = MaxConnections;
            kestrel.Limits.MaxConcurrentUpgradedConnections = MaxTabs;
            kestrel.ListenLocalhost(Port);
        });
        app = builder.Build();
        app.UseWebSockets(new() { KeepAliveInterval = silence / 2, KeepAliveTimeout = silence });
        app.Use(AnswerAsync);
        // The page's own files are part of the program: no request can name a file of the disk.
        app.UseFileServer(new FileServerOptions { FileProvider = new EmbeddedFileProvider(typeof(LiveServer).Assembly, "") });
        app.Run(context => RefuseAsync(context, StatusCodes.Status404NotFound, "There is no such file."));
        Scene.Changed += () => ForEachSession(session => session.Wake());
        Mine.Changed += () => ForEachSession(session => session.CompareAgain());
    }

    public LiveScene Scene { get; }

    public UserPicture Mine { get; }

    public RenderQueue RenderQueue { get; } = new();

    public int Port { get; }

    public string Address => guard.Address;

    /// <param name="mine">The file of a picture by the user's own program to compare with; null for none.</param>
    /// <param name="port">The page's port; null for any that is free.</param>
    /// <param name="clock">By which the files are followed; null for the system's.</param>
    /// <exception cref="ProblemException">The port is taken, or belongs to the system.</exception>
    public static async Task<LiveServer> StartAsync(
        string scene, string? mine = null, int? port = null, TimeProvider? clock = null, int silence = 20)
    {
        for (var attempt = 1; ; attempt++)
        {
            var address = attempt == 1 && PageAddress.Last() is { } last && (port ?? last.Port) == last.Port ? last
                : PageAddress.New(port ?? FreePort());
            var server = new LiveServer(scene, mine, address, clock ?? TimeProvider.System, TimeSpan.FromSeconds(silence));
            try
            {
                await server.app.StartAsync();
                _ = server.Scene.FollowAsync();
                _ = server.Mine.FollowAsync();
                address.Keep();
                return server;
            }
            catch (IOException e)
            {
                await server.DisposeAsync();
                if (port is null && attempt < MaxAttempts) continue;
                var reason = e.InnerException is AddressInUseException ? "is taken" : "cannot be used";
                throw new ProblemException($"port {address.Port} {reason}; choose another one above 1023, or leave --port out");
            }
        }
    }

    public async ValueTask DisposeAsync()
    {
        await end.CancelAsync();
        await app.DisposeAsync();
    }

    private static int FreePort()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        return ((IPEndPoint)listener.LocalEndpoint).Port;
    }

    private void ForEachSession(Action<PageSession> action)
    {
        foreach (var session in sessions.Keys) action(session);
    }

    private async Task AnswerAsync(HttpContext context, RequestDelegate answerWithFile)
    {
        var path = context.Request.Path;
        var method = context.Request.Method;
        if (guard.Refuse(context) is { } reason) await RefuseAsync(context, StatusCodes.Status403Forbidden, reason);
        else if (path == "/live" && context.WebSockets.IsWebSocketRequest) await ServePageAsync(context);
        else if (path == "/mine" && HttpMethods.IsPost(method)) await TakeMineAsync(context);
        else if (!HttpMethods.IsGet(method)) await RefuseAsync(context, StatusCodes.Status405MethodNotAllowed, $"{method} is not allowed here.");
        else await answerWithFile(context);
    }

    private static Task RefuseAsync(HttpContext context, int status, string reason)
    {
        context.Response.StatusCode = status;
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync(reason + "\n");
    }

    private async Task ServePageAsync(HttpContext context)
    {
        using var socket = await context.WebSockets.AcceptWebSocketAsync(context.WebSockets.WebSocketRequestedProtocols[0]);
        using var closed = CancellationTokenSource.CreateLinkedTokenSource(end.Token);
        var connection = new SocketConnection(socket);
        var session = new PageSession(connection, Scene, Mine, RenderQueue, closed.Token);
        sessions.TryAdd(session, 0);
        try
        {
            await Task.WhenAny(connection.ReadAsync(session, closed.Token), session.AnswerAsync());
        }
        finally
        {
            sessions.TryRemove(session, out _);
            await closed.CancelAsync();
            socket.Abort();
        }
    }

    private async Task TakeMineAsync(HttpContext context)
    {
        var scene = Scene.State.Scene;
        // The longest format is a PPM in text: three numbers of five digits and a blank for each pixel. The rest is for its comments.
        var limit = 18 * View.PixelsOf(scene) + 65_536;
        context.Features.Get<IHttpMaxRequestBodySizeFeature>()!.MaxRequestBodySize = limit;
        try
        {
            using var bytes = new MemoryStream();
            await context.Request.Body.CopyToAsync(bytes, context.RequestAborted);
            bytes.Position = 0;
            Mine.Take(context.Request.Query["name"].ToString(), bytes, scene);
            context.Response.StatusCode = StatusCodes.Status204NoContent;
        }
        catch (BadHttpRequestException e)
        {
            await RefuseAsync(context, e.StatusCode, FormattableString.Invariant(
                $"The file has more than {limit:N0} bytes, the limit for a picture of this scene's size: save it as PNG, or as a binary PPM."));
        }
        catch (ProblemException e)
        {
            await RefuseAsync(context, StatusCodes.Status422UnprocessableEntity, e.Message);
        }
    }
}
