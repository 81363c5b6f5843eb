using System.Security.Cryptography;
using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>
/// The folder for the marks of a class. Students' programs may have written into it, too: what is read is signed, and what stands in the way of a
/// file is replaced.
/// </summary>
internal sealed class MarksFolder(string path, byte[] key)
{
    public const string Table = "marks.csv";
    public const string ClassPage = "class.html";
    public const string Moodle = "moodle.csv";
    public const string Canvas = "canvas.csv";
    public static readonly string[] Files = [Table, ClassPage, Moodle, Canvas];

    private const long MaxBytes = 1 << 26;

    /// <summary>The folder of finished marks, from which an interrupted run continues. They name mistakes, so they are not in the students'
    /// folders.</summary>
    private const string Kept = ".kept";

    private readonly Dictionary<string, string> pages = []; // hashes of those that were written

    public string PathOf(params ReadOnlySpan<string> names) => Path.Combine([path, .. names]);

    /// <summary>Refuses a folder in which nothing can be written, before all programs have run.</summary>
    /// <exception cref="ProblemException">It is such a folder.</exception>
    public void ThrowIfNotWritable()
    {
        var probe = PathOf(".writable");
        Write(probe, [0]);
        File.Delete(probe);
    }

    public string PageOf(string student) => PathOf(student, "feedback.html");

    /// <summary>Writes a student's page, and then the marks with a digest of all that they depend on.</summary>
    /// <param name="digest">A hash of the rubric and the submission; null if the marks cannot be kept.</param>
    public StudentMarks Write(StudentMarks marks, string page, string? digest)
    {
        var bytes = Encoding.UTF8.GetBytes(page);
        Write(PageOf(marks.Student), bytes);
        var hash = Convert.ToHexStringLower(SHA256.HashData(bytes));
        lock (pages) pages[marks.Student] = hash;
        marks = marks with { Digest = digest + hash };
        var json = JsonSerializer.SerializeToUtf8Bytes(marks, KeptMarks.Default.StudentMarks);
        if (digest is not null) Write(KeptPathOf(marks.Student), [.. Encoding.ASCII.GetBytes(MarksKey.Sign(key, json)), .. json]);
        return marks;
    }

    /// <summary>The kept marks of a student; null if there are none with this digest and the page that belongs to them.</summary>
    public StudentMarks? Read(string student, string? digest)
    {
        const int signature = 2 * HMACSHA256.HashSizeInBytes;
        if (digest is null || RegularFile.Read(KeptPathOf(student), MaxBytes) is not { Length: > signature } bytes
            || HashOfPage(student) is not { } page
            || !bytes.AsSpan(0, signature).SequenceEqual(Encoding.ASCII.GetBytes(MarksKey.Sign(key, bytes.AsSpan(signature))))) return null;
        try
        {
            var marks = JsonSerializer.Deserialize(bytes.AsSpan(signature), KeptMarks.Default.StudentMarks);
            return marks?.Student == student && marks.Digest == digest + page ? marks : null;
        }
        catch (Exception e) when (e is JsonException or NotSupportedException)
        {
            return null; // of an older version
        }
    }

    /// <summary>The pages that this run wrote and somebody else changed.</summary>
    public IEnumerable<string> ChangedPages() => pages.Where(page => HashOfPage(page.Key) != page.Value).Select(page => PageOf(page.Key)).Order();

    /// <summary>Writes a file, and makes its folder: a student's program may have deleted it, or put a pipe or a link there.</summary>
    /// <exception cref="ProblemException">It cannot be written.</exception>
    public static void Write(string path, byte[] bytes)
    {
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
            if (new FileInfo(path) is var old && (old.LinkTarget is not null || old is { Exists: true, Length: 0 })) File.Delete(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new ProblemException($"cannot write {path}: {ProblemException.Reason(e)}", e);
        }
        WrittenFiles.Write(path, file => file.Write(bytes));
    }

    private string KeptPathOf(string student) => PathOf(Kept, student + ".json");

    private string? HashOfPage(string student) =>
        RegularFile.Read(PageOf(student), MaxBytes) is { } page ? Convert.ToHexStringLower(SHA256.HashData(page)) : null;
}
