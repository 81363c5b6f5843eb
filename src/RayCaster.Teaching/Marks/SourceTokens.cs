using System.Security.Cryptography;
using System.Text.RegularExpressions;

namespace RayCaster.Teaching;

/// <summary>Finds submissions of the same source, up to names, comments and layout.</summary>
internal static partial class SourceTokens
{
    private const long MaxBytes = 1 << 20;

    /// <summary>Shorter sources are alike by chance.</summary>
    private const int MinTokens = 200;

    private static readonly HashSet<string> endings =
    [
        ".c", ".cc", ".cpp", ".cs", ".cu", ".fs", ".go", ".h", ".hpp", ".java", ".jl", ".js", ".kt", ".m", ".pas", ".py", ".rb", ".rs", ".scala",
        ".swift", ".ts", ".zig",
    ];

    /// <summary>The students who handed in the same source as somebody else, each with the others.</summary>
    public static Dictionary<string, string> Repeated(IEnumerable<Submission> all)
    {
        var groups = all.AsParallel().Select(submission => (submission.Student, Hash: HashOf(submission.Folder))).Where(source => source.Hash != "")
            .GroupBy(source => source.Hash, source => source.Student).Where(group => group.Count() > 1);
        return groups.SelectMany(group => group.Select(student => (student, string.Join(", ", group.Where(other => other != student).Order()))))
            .ToDictionary();
    }

    /// <summary>A hash of all sources in a folder; empty if they are too short. The order of files does not count, as names do not.</summary>
    private static string HashOf(string folder)
    {
        var (hashes, count) = (new List<string>(), 0);
        foreach (var (path, _) in Submission.State(folder))
        {
            if (!endings.Contains(Path.GetExtension(path).ToLowerInvariant()) || IsBuilt(Path.GetRelativePath(folder, path))) continue;
            var text = Encoding.UTF8.GetString(RegularFile.Read(path, MaxBytes) ?? []);
            string[] tokens = [.. Token().Matches(text).Where(token => !token.Groups["comment"].Success).Select(token =>
                token.Groups["name"].Success ? "a" : token.Value)];
            count += tokens.Length;
            hashes.Add(Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(string.Join('\n', tokens)))));
        }
        return count < MinTokens ? "" : string.Concat(hashes.Order());
    }

    private static bool IsBuilt(string path) => path.Split(Path.DirectorySeparatorChar).Any(part => part is "bin" or "obj" or "node_modules");

    [GeneratedRegex(@"(?<comment>//.*|/\*[\s\S]*?\*/|(?<=^|\s)#\s.*)|""(?:\\.|[^""\\\n])*""|(?<name>[\p{L}_]\w*)|\d[\w.]*|\S")]
    private static partial Regex Token();
}
