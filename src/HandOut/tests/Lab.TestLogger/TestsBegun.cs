namespace Lab.TestLogger;

/// <summary>
/// The tests of a run as they begin and end, in a file beside the assemblies. The tests' own process writes it: if that is stopped, it says which
/// tests were running.
/// </summary>
public sealed class TestsBegun : IDisposable
{
    private readonly StreamWriter file;

    /// <param name="path">The file; another run's is overwritten.</param>
    public TestsBegun(string path) =>
        file = new(new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete)) { AutoFlush = true };

    /// <summary>Where the tests write it.</summary>
    public static string Path { get; } = System.IO.Path.ChangeExtension(typeof(TestsBegun).Assembly.Location, ".begun");

    /// <param name="name">Of the test's method, with its class.</param>
    /// <param name="displayName">With the numbers of the InlineData, too.</param>
    public void Begin(string name, string displayName) => Write('+', name, displayName);

    /// <summary>A test has come to its end, well or not.</summary>
    public void End(string name, string displayName) => Write('-', name, displayName);

    /// <summary>The tests that have begun and not ended; none if there is no such file.</summary>
    public static (string Name, string DisplayName)[] Running(string path)
    {
        if (!File.Exists(path)) return [];
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete));
        var running = new List<(string, string)>();
        while (reader.ReadLine()?.Split('\t') is [{ Length: > 0 } name, var displayName])
            if (name[0] == '+') running.Add((name[1..], displayName));
            else running.Remove((name[1..], displayName));
        return [.. running];
    }

    public void Dispose() => file.Dispose();

    private void Write(char change, string name, string displayName)
    {
        lock (file) file.Write($"{change}{name}\t{displayName.ReplaceLineEndings(" ").Replace('\t', ' ')}\n");
    }
}
