using System.IO.Compression;

namespace RayCaster.Browser.Tests;

/// <summary>The page of the folder, which holds the scene's text itself.</summary>
internal sealed class FolderPage(Tab tab, FileServer server, bool isAlone) : HostedPage(tab)
{
    public FileServer Server => server;

    /// <param name="fragment">What follows the address; an empty text for the page's first scene, which takes a browser seconds to draw.</param>
    /// <param name="script">What is done before any script of the page.</param>
    public static async Task<FolderPage> OpenAsync(Chromium chromium, Site site, string? fragment = null, string script = "") =>
        await ShownAsync(new(await chromium.OpenAsUsualAsync(script), await site.ServeAsUsualAsync(), isAlone: false), fragment);

    /// <summary>Opens the page of a server that no other test asks, and that this browser has not visited.</summary>
    /// <param name="isProxied">Whether requests for other hosts reach the file server, too.</param>
    /// <inheritdoc cref="Site.ServeAsync"/>
    public static async Task<FolderPage> FirstVisitAsync(
        Chromium chromium, Site site, string? fragment = null, string below = "", Oddity? oddity = null, bool isProxied = false)
    {
        var server = await site.ServeAsync(below, oddity);
        return await ShownAsync(new(await chromium.OpenAsync(isProxied ? server.Root : null), server, isAlone: true), fragment);
    }

    private static async Task<FolderPage> ShownAsync(FolderPage web, string? fragment)
    {
        await web.Tab.ShowAsync(web.Server.Address + (fragment ?? Link(Ball)));
        return web;
    }

    /// <summary>A link's part that holds a scene.</summary>
    public static string Link(string scene)
    {
        using var packed = new MemoryStream();
        using (var deflate = new DeflateStream(packed, CompressionLevel.Optimal, leaveOpen: true)) deflate.Write(Encoding.UTF8.GetBytes(scene));
        return "#scene=" + Convert.ToBase64String(packed.ToArray()).Replace('+', '-').Replace('/', '_').TrimEnd('=');
    }

    public override Task<string> SceneTextAsync() => Page.EvaluateExpressionAsync<string>("document.getElementById('scene-text').value");

    /// <summary>Puts a text into the editor, as if it were pasted.</summary>
    public override Task WriteSceneAsync(string text) => Page.EvaluateFunctionAsync("""
        text => {
            const editor = document.getElementById('scene-text');
            editor.value = text;
            editor.dispatchEvent(new Event('input', { bubbles: true }));
        }
        """, text);

    public override async ValueTask DisposeAsync()
    {
        await base.DisposeAsync();
        if (isAlone) await server.DisposeAsync();
    }
}
