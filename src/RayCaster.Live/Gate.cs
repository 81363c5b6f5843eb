using System.Security.Cryptography;
using System.Text;
using Microsoft.AspNetCore.Http;

namespace RayCaster.Live;

/// <summary>
/// Accepts requests of the page only. Other users of this machine do not know the token in the page's address; other pages in the same browser
/// send another Host, Origin or Sec-Fetch-Site.
/// </summary>
internal sealed class Gate(int port, string token)
{
    private const string Policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; " +
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private readonly string[] hosts = [$"127.0.0.1:{port}", $"localhost:{port}", $"[::1]:{port}"];
    private readonly string cookie = $"raycaster-live-{port}";

    public string Address => $"http://127.0.0.1:{port}/?token={token}";

    /// <summary>Sets the headers of the answer and checks the request.</summary>
    /// <returns>Null if the page may have sent it; otherwise the reason against it.</returns>
    public string? Refuse(HttpContext context)
    {
        var (request, headers) = (context.Request, context.Response.Headers);
        headers.ContentSecurityPolicy = Policy;
        headers.XContentTypeOptions = "nosniff";
        headers.XFrameOptions = "DENY";
        headers.CacheControl = "no-store";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers["Cross-Origin-Opener-Policy"] = "same-origin";

        var host = request.Headers.Host.ToString();
        if (!hosts.Contains(host, StringComparer.OrdinalIgnoreCase)) return $"This server answers only as 127.0.0.1:{port} or localhost:{port}.";
        var origin = request.Headers.Origin;
        var mayChange = context.WebSockets.IsWebSocketRequest || !HttpMethods.IsGet(request.Method);
        if (origin.Count > 0 || mayChange)
            if (!string.Equals(origin.ToString(), $"http://{host}", StringComparison.OrdinalIgnoreCase))
                return "This request comes from another page.";
        if (request.Headers["Sec-Fetch-Site"] is [{ Length: > 0 } site] && site is not ("same-origin" or "none"))
            return "This request comes from another page.";

        if (request.Cookies[cookie] is { } known && IsToken(known)) return null;
        if (request.Path == "/" && HttpMethods.IsGet(request.Method) && IsToken(request.Query["token"].ToString()))
        {
            context.Response.Cookies.Append(cookie, token, new() { HttpOnly = true, SameSite = SameSiteMode.Strict, Path = "/" });
            return null;
        }
        return "Open the page by the address that the program printed: this request lacks the token of that address.";
    }

    private bool IsToken(string text) => CryptographicOperations.FixedTimeEquals(Encoding.UTF8.GetBytes(text), Encoding.UTF8.GetBytes(token));
}
