using System.Security.Cryptography;

namespace RayCaster.Live;

/// <summary>
/// The port and the secret in a page's address. Under "dotnet watch", which starts the program again after each change of the code, they stay the
/// same, so that an open page connects again: a file that only this user may read keeps them.
/// </summary>
/// <param name="Port">0 for any that is free.</param>
internal sealed record PageAddress(int Port, string Token)
{
    /// <summary>How often "dotnet watch" has started the program; 0 without "dotnet watch".</summary>
    private static readonly int iteration =
        int.TryParse(Environment.GetEnvironmentVariable("DOTNET_WATCH_ITERATION"), CultureInfo.InvariantCulture, out var count) ? count : 0;

    private static string KeptIn => PrivateFile.PathOf(Environment.SpecialFolder.LocalApplicationData, "raycaster-live");

    /// <summary>Whether a page is probably open already.</summary>
    public static bool IsRestart => iteration > 1;

    public static PageAddress New(int port) => new(port, Convert.ToHexStringLower(RandomNumberGenerator.GetBytes(16)));

    /// <summary>The address before "dotnet watch" has started the program again; null if there is none.</summary>
    public static PageAddress? Last()
    {
        try
        {
            return IsRestart && File.ReadAllText(KeptIn).Split(' ') is [var port, var token]
                ? new(int.Parse(port, CultureInfo.InvariantCulture), token) : null;
        }
        catch (Exception e) when (e is FormatException || ProblemException.IsCausedByFile(e))
        {
            return null;
        }
    }

    public void Keep()
    {
        if (iteration == 0) return;
        try
        {
            PrivateFile.Write(KeptIn, FormattableString.Invariant($"{Port} {Token}"));
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            // After the next start the page must be opened by its new address, which the terminal shows.
        }
    }
}
