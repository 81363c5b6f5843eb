using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Ci;

/// <summary>What git knows of the project.</summary>
internal static class Repository
{
    /// <summary>The commit that is tested.</summary>
    public static string Commit { get; } = Git("rev-parse", "HEAD")?.Trim() ?? throw new InvalidOperationException("this is no clone of git's");

    /// <summary>A number made of the commit, from 1 to 16,777,216.</summary>
    public static int Seed => 1 + int.Parse(Commit.AsSpan(0, 6), NumberStyles.HexNumber, CultureInfo.InvariantCulture);

    /// <summary>The commits before this one, the nearest first.</summary>
    public static IEnumerable<string> Ancestors => Lines(Git("rev-list", "--max-count=500", "HEAD")).Skip(1);

    /// <summary>The files that differ from a commit, also those that are not committed; null if there is no such commit.</summary>
    public static IReadOnlyCollection<string>? ChangedSince(string commit) =>
        Git("diff", "--name-only", commit) is { } changed ? [.. Lines(changed), .. Lines(Git("ls-files", "--others", "--exclude-standard"))] : null;

    private static string[] Lines(string? text) => (text ?? "").Split('\n', StringSplitOptions.RemoveEmptyEntries);

    private static string? Git(params string[] arguments)
    {
        using var git = Process.Start(new ProcessStartInfo("git", arguments) { RedirectStandardOutput = true, RedirectStandardError = true })!;
        git.ErrorDataReceived += (_, _) => { };
        git.BeginErrorReadLine();
        var output = git.StandardOutput.ReadToEnd();
        git.WaitForExit();
        return git.ExitCode == 0 ? output : null;
    }
}
