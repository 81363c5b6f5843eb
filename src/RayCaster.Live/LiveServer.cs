using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.Extensions.FileProviders;

namespace RayCaster.Live;

/// <summary>Serves the page on this machine's own addresses only.</summary>
internal sealed class LiveServer : IAsyncDisposable
{
    /// <summary>How many pages may be open at once; each takes the memory of two pictures.</summary>
    private const int MostTabs = 64;

    private readonly ConcurrentDictionary<Tab, byte> tabs = new();
    private readonly CancellationTokenSource end = new();
    private readonly Gate gate;
    private readonly WebApplication app;
    private byte[]? errors; // the last message about the code; pages that are opened later receive it, too

    private LiveServer(LiveOptions options, Socket listener)
    {
        (Scene, Mine, Port) = (new(options.Scene, end.Token), new(options.Mine, end.Token), ((IPEndPoint)listener.LocalEndPoint!).Port);
        gate = new(Port, Convert.ToHexStringLower(DotnetWatch.Secret));
        var builder = WebApplication.CreateEmptyBuilder(new());
        builder.WebHost.UseKestrelCore().UseSockets(sockets => sockets.CreateBoundListenSocket = _ => listener).ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxRequestBodySize = 0;
            kestrel.Listen(listener.LocalEndPoint!);
        });
        app = builder.Build();
        app.UseWebSockets(new() { KeepAliveInterval = TimeSpan.FromSeconds(10), KeepAliveTimeout = TimeSpan.FromSeconds(20) });
        app.Use(AnswerAsync);
        // The page's own files are part of the program: no request can name a file of the disk.
        app.UseFileServer(new FileServerOptions { FileProvider = new EmbeddedFileProvider(typeof(LiveServer).Assembly, "") });
        app.Run(context => RefuseAsync(context, StatusCodes.Status404NotFound, "There is no such file."));
        Scene.Changed += () => ForEachTab(tab => tab.Wake());
        Mine.Changed += () => ForEachTab(tab => tab.CompareAgain());
    }

    public LiveScene Scene { get; }

    /// <summary>The picture that the scene's picture is compared with.</summary>
    public MinePicture Mine { get; }

    public Studio Studio { get; } = new();

    public int Port { get; }

    /// <summary>The page's address, with its secret.</summary>
    public string Address => gate.Address;

    /// <exception cref="ProblemException">The port is taken, or belongs to the system.</exception>
    public static async Task<LiveServer> StartAsync(LiveOptions options)
    {
        var server = new LiveServer(options, Listener(options.Port));
        await server.app.StartAsync();
        _ = server.Scene.FollowAsync();
        _ = server.Mine.FollowAsync();
        _ = DotnetWatch.FollowAsync(server.ShowErrors, server.end.Token);
        return server;
    }

    /// <summary>Shows on all pages what keeps the code from being built.</summary>
    /// <param name="found">The compiler's errors; none when the code compiles again.</param>
    public void ShowErrors(IReadOnlyList<Problem> found)
    {
        var message = Messages.OfCode(found);
        errors = message;
        ForEachTab(tab => tab.Post(message));
    }

    public async ValueTask DisposeAsync()
    {
        await end.CancelAsync();
        await app.DisposeAsync();
    }

    /// <summary>Takes a port of 127.0.0.1.</summary>
    /// <param name="port">Its number; 0 for the same as before a restart by "dotnet watch", or any that is free.</param>
    private static Socket Listener(int port)
    {
        try
        {
            return Bound(port > 0 ? port : DotnetWatch.Port);
        }
        catch (SocketException) when (port == 0)
        {
            return Bound(0);
        }
        catch (SocketException e)
        {
            var reason = e.SocketErrorCode == SocketError.AddressAlreadyInUse ? "is taken" : "cannot be used";
            throw new ProblemException($"raycaster-live: port {port} {reason}; choose another one above 1023, or leave --port out");
        }

        static Socket Bound(int port)
        {
            var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            socket.Bind(new IPEndPoint(IPAddress.Loopback, port));
            return socket;
        }
    }

    private void ForEachTab(Action<Tab> action)
    {
        foreach (var tab in tabs.Keys) action(tab);
    }

    private async Task AnswerAsync(HttpContext context, RequestDelegate answerWithFile)
    {
        var (path, method) = (context.Request.Path, context.Request.Method);
        if (gate.Refuse(context) is { } reason) await RefuseAsync(context, StatusCodes.Status403Forbidden, reason);
        else if (path == "/live" && context.WebSockets.IsWebSocketRequest) await ServeTabAsync(context);
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

    private async Task ServeTabAsync(HttpContext context)
    {
        if (tabs.Count >= MostTabs)
        {
            await RefuseAsync(context, StatusCodes.Status503ServiceUnavailable, $"{MostTabs} pages are open already; close some.");
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

    /// <summary>Receives a picture of the user's own program, of the scene's size at most.</summary>
    private async Task TakeMineAsync(HttpContext context)
    {
        var camera = Scene.State.Scene?.Camera;
        var pixels = Math.Min(View.MostPixels, (long)(camera?.Width ?? 0) * (camera?.Height ?? 0));
        // The longest format is a PPM in text: three numbers of four characters for each pixel. The rest is for its comments.
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
            await RefuseAsync(context, e.StatusCode, "The file is larger than any picture of this scene's size.");
        }
        catch (PictureFileException e)
        {
            await RefuseAsync(context, StatusCodes.Status422UnprocessableEntity, e.Message);
        }
    }

    /// <summary>The name of a dropped file, without folders and control characters.</summary>
    private static string NameOf(string text)
    {
        var name = string.Concat(Path.GetFileName(text.Replace('\\', '/')).Where(c => !char.IsControl(c)));
        return name.Length == 0 ? "your picture" : name[..Math.Min(100, name.Length)];
    }
}
