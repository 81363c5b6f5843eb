using System.Collections.Concurrent;
using System.Diagnostics;
using System.Text.RegularExpressions;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.FileProviders;
using Microsoft.Extensions.Logging;

namespace RayCaster.Browser.Tests;

/// <summary>The tests of the page without a server, which share the published folder.</summary>
[CollectionDefinition("folder")]
public class FolderCollection : ICollectionFixture<Chromium>, ICollectionFixture<Site>;

/// <summary>The folder that a course hosts, published once for all tests; RAYCASTER_SITE may name one that is published already.</summary>
public sealed partial class Site : IAsyncLifetime
{
    private static readonly string? published = Environment.GetEnvironmentVariable("RAYCASTER_SITE");

    private readonly TemporaryFolder folder = new();
    private bool cannotBeRestored;
    private Task<FileServer>? usual;

    /// <summary>The published files.</summary>
    internal IEnumerable<string> Files()
    {
        Assert.SkipWhen(cannotBeRestored, "the runtime pack for browser-wasm cannot be restored");
        return Directory.EnumerateFiles(published ?? folder.Path, "*", SearchOption.AllDirectories);
    }

    public async ValueTask InitializeAsync()
    {
        if (!File.Exists(Chromium.Program) || published is not null) return;
        var (code, text) = await PublishAsync();
        cannotBeRestored = code != 0 && Unrestored().IsMatch(text);
        if (code != 0 && !cannotBeRestored) throw new InvalidOperationException(text);
    }

    /// <summary>Serves the folder as any web host does.</summary>
    /// <param name="below">The folder of the host that it is copied to.</param>
    /// <param name="oddity">What this host does otherwise.</param>
    internal Task<FileServer> ServeAsync(string below = "", Oddity? oddity = null)
    {
        Assert.SkipWhen(cannotBeRestored, "the runtime pack for browser-wasm cannot be restored");
        return FileServer.StartAsync(published ?? folder.Path, below, oddity);
    }

    /// <summary>The server of all tests that ask nothing particular of it: a browser need not compile the program again for each of them.</summary>
    internal Task<FileServer> ServeAsUsualAsync() => usual ??= ServeAsync();

    public async ValueTask DisposeAsync()
    {
        if (usual is not null) await (await usual).DisposeAsync();
        folder.Dispose();
    }

    private async Task<(int Code, string Text)> PublishAsync()
    {
        using var publish = Process.Start(new ProcessStartInfo(
            "dotnet", ["publish", ProjectFolder.PathOf("src/RayCaster.Web"), "-c", "Release", "-o", folder.Path, "-v", "q", "-tl:off"])
        {
            RedirectStandardOutput = true,
        })!;
        var text = await publish.StandardOutput.ReadToEndAsync();
        await publish.WaitForExitAsync();
        return (publish.ExitCode, text);
    }

    /// <summary>Errors of a package that is not there, or of a source that does not answer.</summary>
    [GeneratedRegex(@"error NU1(10\d|301)")]
    private static partial Regex Unrestored();
}

/// <summary>What a host does otherwise than others: a step before a file is sent.</summary>
internal delegate Task Oddity(HttpContext context, Func<Task> next);

/// <summary>A server of files and nothing else. A browser may also use it as its proxy: then it hears of requests for other hosts, too.</summary>
internal sealed class FileServer(WebApplication server, ConcurrentQueue<string> requests, string below) : IAsyncDisposable
{
    public string Root => server.Urls.Single();

    /// <summary>The page's address.</summary>
    public string Address => $"{Root}{below}/";

    /// <summary>All requests so far: their addresses and the status that was answered.</summary>
    public string[] Requests => [.. requests];

    public static async Task<FileServer> StartAsync(string folder, string below, Oddity? oddity)
    {
        var builder = WebApplication.CreateSlimBuilder();
        builder.Logging.ClearProviders();
        builder.WebHost.UseUrls("http://127.0.0.1:0");
        var server = builder.Build();
        var requests = new ConcurrentQueue<string>();
        server.Use(async (context, next) =>
        {
            var request = context.Request;
            if ($"{request.Scheme}://{request.Host}" == server.Urls.Single() && !HttpMethods.IsConnect(request.Method)) await next();
            else context.Response.StatusCode = StatusCodes.Status502BadGateway;
            requests.Enqueue($"{request.Method} {request.Scheme}://{request.Host}{request.Path}{request.QueryString} {context.Response.StatusCode}");
        });
        if (oddity is not null) server.Use((context, next) => oddity(context, next));
        server.UseFileServer(new FileServerOptions { FileProvider = new PhysicalFileProvider(folder), RequestPath = below });
        server.Run(async context => // as hosts do for a file that they do not have
        {
            context.Response.StatusCode = StatusCodes.Status404NotFound;
            context.Response.ContentType = "text/html";
            await context.Response.SendFileAsync(Path.Combine(folder, "404.html"));
        });
        await server.StartAsync();
        return new(server, requests, below);
    }

    public ValueTask DisposeAsync() => server.DisposeAsync();
}
