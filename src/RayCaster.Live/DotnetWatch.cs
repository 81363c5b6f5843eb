using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace RayCaster.Live;

/// <summary>
/// The connection to "dotnet watch", which sends the compiler's errors to a script of its own in web pages. The page's Content-Security-Policy
/// forbids that script, so the server connects in its place. Everything here does nothing without "dotnet watch".
/// </summary>
internal static partial class DotnetWatch
{
    private static readonly string? address = Environment.GetEnvironmentVariable("ASPNETCORE_AUTO_RELOAD_WS_ENDPOINT")?.Split(',')[0];
    private static readonly string? key = Environment.GetEnvironmentVariable("ASPNETCORE_AUTO_RELOAD_WS_KEY");

    /// <summary>
    /// 16 random bytes. They stay the same after each restart by the same "dotnet watch", so that an open page finds the program again: then they
    /// come from a key that only the processes of this "dotnet watch" know.
    /// </summary>
    public static byte[] Secret { get; } =
        key is null ? RandomNumberGenerator.GetBytes(16) : SHA256.HashData(Encoding.UTF8.GetBytes(key))[..16];

    /// <summary>A port from 49152 to 65535 that stays the same after a restart; 0 without "dotnet watch".</summary>
    public static int Port => key is null ? 0 : 49152 + (Secret[0] << 8 | Secret[1]) % 16384;

    /// <summary>Whether "dotnet watch" has started this program before, so that a page is open already.</summary>
    public static bool IsRestart =>
        int.TryParse(Environment.GetEnvironmentVariable("DOTNET_WATCH_ITERATION"), CultureInfo.InvariantCulture, out var count) && count > 1;

    /// <summary>Reports the compiler's errors after each build that fails, and an empty list when the code compiles again.</summary>
    public static async Task FollowAsync(Action<IReadOnlyList<Problem>> report, CancellationToken cancellation)
    {
        if (address is null || key is null) return;
        try
        {
            using var socket = new ClientWebSocket();
            socket.Options.SetRequestHeader("Origin", "http://localhost");
            socket.Options.AddSubProtocol(WebUtility.UrlEncode(Convert.ToBase64String(Encrypted(key))));
            await socket.ConnectAsync(new(address), cancellation);
            while (socket.State == WebSocketState.Open)
            {
                using var message = new StreamReader(WebSocketStream.CreateReadableMessageStream(socket));
                if (Parse(await message.ReadToEndAsync(cancellation)) is { } errors) report(errors);
            }
        }
        catch (Exception e) when (
            e is WebSocketException or OperationCanceledException or JsonException or CryptographicException or FormatException)
        {
            // "dotnet watch" has ended, or another SDK uses another protocol. The terminal shows the errors in any case.
        }
    }

    /// <summary>The errors of one message, without lines of other forms; null if the message is of another type.</summary>
    public static IReadOnlyList<Problem>? Parse(string message)
    {
        using var document = JsonDocument.Parse(message);
        var root = document.RootElement;
        return root.TryGetProperty("type", out var type) && type.ValueEquals("ReportDiagnostics")
            ? [.. from line in root.GetProperty("diagnostics").EnumerateArray()
                  let match = CompilerError().Match(line.GetString()!)
                  where match.Success
                  select new Problem(true, match.Groups[1].Value, Number(match, 2), Number(match, 3), match.Groups[4].Value, "")]
            : null;
    }

    private static int Number(Match match, int group) => int.Parse(match.Groups[group].ValueSpan, CultureInfo.InvariantCulture);

    /// <summary>"file(line,column): error CS1002: ; expected".</summary>
    [GeneratedRegex(@"^(.+)\((\d{1,9}),(\d{1,9})\): (?:error|warning) (.+)$", RegexOptions.Singleline)]
    private static partial Regex CompilerError();

    /// <summary>The random bytes that "dotnet watch" demands of each connection; only its own script uses them later.</summary>
    private static byte[] Encrypted(string key)
    {
        using var rsa = RSA.Create();
        rsa.ImportSubjectPublicKeyInfo(Convert.FromBase64String(key), out _);
        return rsa.Encrypt(RandomNumberGenerator.GetBytes(32), RSAEncryptionPadding.OaepSHA256);
    }
}
