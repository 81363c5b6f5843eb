using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace RayCaster.Live;

/// <summary>A compiler's message.</summary>
/// <param name="File">Its file, from the root of the file system.</param>
/// <param name="Line">Its line, from 1.</param>
/// <param name="Column">Its column, from 1.</param>
/// <param name="Message">What is wrong.</param>
internal sealed record CodeError(string File, int Line, int Column, string Message);

/// <summary>
/// The line to "dotnet watch", over which that program sends the compiler's errors to its own script in web pages. The script would break this page's
/// rule that only its own scripts run, so the server listens here instead.
/// </summary>
internal static partial class WatchLine
{
    private static readonly string? address = Environment.GetEnvironmentVariable("ASPNETCORE_AUTO_RELOAD_WS_ENDPOINT")?.Split(',')[0];
    private static readonly string? key = Environment.GetEnvironmentVariable("ASPNETCORE_AUTO_RELOAD_WS_KEY");

    /// <summary>
    /// 16 bytes that stay the same while "dotnet watch" starts this program again and again, so that an open page finds the new one: from a key that
    /// only the processes of this "dotnet watch" know. Null without "dotnet watch".
    /// </summary>
    public static byte[]? Secret { get; } = key is null ? null : SHA256.HashData(Encoding.UTF8.GetBytes(key))[..16];

    /// <summary>Whether "dotnet watch" has started this program before: a page is open already.</summary>
    public static bool IsRestart => int.TryParse(Environment.GetEnvironmentVariable("DOTNET_WATCH_ITERATION"), out var count) && count > 1;

    /// <summary>Reports the compiler's errors whenever they change, none when the code compiles again. Ends at once without "dotnet watch".</summary>
    /// <param name="report">Takes the errors.</param>
    /// <param name="cancellation">Ends it.</param>
    public static async Task FollowAsync(Action<IReadOnlyList<CodeError>> report, CancellationToken cancellation)
    {
        if (address is null || key is null) return;
        try
        {
            using var socket = new ClientWebSocket();
            socket.Options.SetRequestHeader("Origin", "http://localhost");
            socket.Options.AddSubProtocol(WebUtility.UrlEncode(Convert.ToBase64String(Encrypted(key))));
            await socket.ConnectAsync(new(address), cancellation);
            var (buffer, filled, last) = (new byte[1 << 20], 0, "");
            while (socket.State == WebSocketState.Open)
            {
                var part = await socket.ReceiveAsync(buffer.AsMemory(filled), cancellation);
                filled += part.Count;
                if (!part.EndOfMessage && filled < buffer.Length) continue;
                var text = Encoding.UTF8.GetString(buffer.AsSpan(0, filled));
                filled = 0;
                if (text == last || Parse(text) is not { } errors) continue;
                last = text;
                report(errors);
            }
        }
        catch (Exception e) when (e is WebSocketException or OperationCanceledException or JsonException or CryptographicException or FormatException)
        {
            // The watch has ended, or another SDK speaks otherwise: the terminal shows the errors as well.
        }
    }

    /// <summary>The errors of one message; null if it tells something else. Lines in it that are no compiler's messages are left out.</summary>
    public static IReadOnlyList<CodeError>? Parse(string message)
    {
        var root = JsonDocument.Parse(message).RootElement;
        return root.TryGetProperty("type", out var type) && type.ValueEquals("ReportDiagnostics")
            ? [.. from line in root.GetProperty("diagnostics").EnumerateArray()
                  let match = Form().Match(line.GetString()!)
                  where match.Success
                  select new CodeError(match.Groups[1].Value, Number(match, 2), Number(match, 3), match.Groups[4].Value)]
            : null;
    }

    private static int Number(Match match, int group) => int.Parse(match.Groups[group].ValueSpan, CultureInfo.InvariantCulture);

    /// <summary>"file(line,column): error CS1002: ; expected".</summary>
    [GeneratedRegex(@"^(.+)\((\d{1,9}),(\d{1,9})\): (?:error|warning) (.+)$", RegexOptions.Singleline)]
    private static partial Regex Form();

    /// <summary>A secret that "dotnet watch" wants of whoever connects, and of which it then makes no use here.</summary>
    private static byte[] Encrypted(string key)
    {
        using var rsa = RSA.Create();
        rsa.ImportSubjectPublicKeyInfo(Convert.FromBase64String(key), out _);
        return rsa.Encrypt(RandomNumberGenerator.GetBytes(32), RSAEncryptionPadding.OaepSHA256);
    }
}
