using Microsoft.AspNetCore.Http;

namespace RayCaster.Live;

/// <summary>The page's own files, which are part of the program: no request can name a file of the disk.</summary>
internal sealed class PageFiles
{
    private readonly Dictionary<string, (byte[] Bytes, string Type)> files = [];

    public PageFiles()
    {
        var assembly = typeof(PageFiles).Assembly;
        foreach (var name in assembly.GetManifestResourceNames())
        {
            using var stream = assembly.GetManifestResourceStream(name)!;
            var bytes = new byte[stream.Length];
            stream.ReadExactly(bytes);
            files[name == "index.html" ? "/" : "/" + name] = (bytes, TypeOf(name));
        }
    }

    /// <summary>Answers with a file of the page.</summary>
    /// <returns>False if there is no such file.</returns>
    public async Task<bool> TryAnswerAsync(HttpContext context)
    {
        if (!files.TryGetValue(context.Request.Path.Value ?? "", out var file)) return false;
        context.Response.ContentType = file.Type;
        context.Response.ContentLength = file.Bytes.Length;
        await context.Response.Body.WriteAsync(file.Bytes, context.RequestAborted);
        return true;
    }

    private static string TypeOf(string name) => Path.GetExtension(name) switch
    {
        ".html" => "text/html; charset=utf-8",
        ".css" => "text/css; charset=utf-8",
        ".js" => "text/javascript; charset=utf-8",
        _ => "image/svg+xml",
    };
}
