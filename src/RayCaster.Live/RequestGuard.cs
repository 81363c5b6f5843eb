using System.Security.Cryptography;
using Microsoft.AspNetCore.Http;

namespace RayCaster.Live;

/// <summary>
/// Accepts requests of the page only. The page's own files hold no secret and are served to every local program. What reads or changes a scene
/// must name the token in the page's address, which other users of this machine do not know, and must come from the page itself.
/// </summary>
internal sealed class RequestGuard(int port, string token)
{
    private const string Policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; " +
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private readonly string[] hosts = [$"127.0.0.1:{port}", $"localhost:{port}", $"[::1]:{port}"];

    /// <summary>The page's address. Browsers do not send the part after "#"; the page's script keeps it for its own tab.</summary>
    public string Address => $"http://127.0.0.1:{port}/#token={token}";

    /// <summary>Sets the headers of the answer and checks the request.</summary>
    /// <returns>Null if the page may have sent it; otherwise the reason against it.</returns>
    public string? Refuse(HttpContext context)
    {
        var request = context.Request;
        var headers = context.Response.Headers;
        headers.ContentSecurityPolicy = Policy;
        headers.XContentTypeOptions = "nosniff";
        headers.XFrameOptions = "DENY";
        headers.CacheControl = "no-store";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers["Cross-Origin-Opener-Policy"] = "same-origin";

        var host = request.Headers.Host.ToString();
        if (!hosts.Contains(host, StringComparer.OrdinalIgnoreCase)) return $"This server answers only as 127.0.0.1:{port} or localhost:{port}.";
        var isSocket = context.WebSockets.IsWebSocketRequest;
        if (HttpMethods.IsGet(request.Method) && !isSocket) return null;
        if (!string.Equals(request.Headers.Origin, $"http://{host}", StringComparison.OrdinalIgnoreCase))
            return "This request comes from another page.";
        var named = isSocket ? context.WebSockets.WebSocketRequestedProtocols.FirstOrDefault() : request.Headers.Authorization.ToString();
        return CryptographicOperations.FixedTimeEquals(Encoding.UTF8.GetBytes(named ?? ""), Encoding.UTF8.GetBytes(token))
            ? null : "Open the page by the address that the program printed: this request lacks the token of that address.";
    }
}
