namespace RayCaster.Teaching;

/// <summary>Process trees as Linux reports them; other systems report none.</summary>
internal static class ProcessTree
{
    private const int Parent = 1, ResidentPages = 21; // fields of /proc/N/stat after the name

    /// <summary>A process and all that descend from it, parents before their children, each with the bytes of memory that it holds.</summary>
    public static List<(int Id, int Parent, long Memory)> Of(int root)
    {
        if (!OperatingSystem.IsLinux()) return [];
        var all = All().ToList();
        var children = all.ToLookup(process => process.Parent);
        var found = all.FindAll(process => process.Id == root);
        var known = new HashSet<int> { root }; // a process number may be used anew while this reads: no circles
        for (var i = 0; i < found.Count; i++) found.AddRange(children[found[i].Id].Where(child => known.Add(child.Id)));
        return found;
    }

    /// <summary>The number of processes and threads of the system; 0 if unknown. One short read, so it can be called often.</summary>
    public static int TaskCount()
    {
        if (!OperatingSystem.IsLinux()) return 0;
        var words = Encoding.ASCII.GetString(Read("/proc/loadavg")).Split(' ', '/'); // 0.20 0.18 0.12 1/80 11206
        return words.Length > 4 && int.TryParse(words[4], NumberStyles.None, CultureInfo.InvariantCulture, out var count) ? count : 0;
    }

    /// <summary>The processes that were started with this environment variable.</summary>
    public static IEnumerable<int> WithVariable(string name, string value)
    {
        if (!OperatingSystem.IsLinux()) yield break;
        var sought = Encoding.UTF8.GetBytes($"{name}={value}\0");
        foreach (var id in Ids())
            if (Read($"/proc/{id}/environ").AsSpan().IndexOf(sought) >= 0)
                yield return id;
    }

    private static IEnumerable<(int Id, int Parent, long Memory)> All()
    {
        foreach (var id in Ids())
        {
            var stat = Encoding.ASCII.GetString(Read($"/proc/{id}/stat"));
            // The name before the fields may contain blanks and parentheses.
            var fields = stat[(stat.LastIndexOf(')') + 1)..].Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (fields.Length <= ResidentPages) continue; // the process has ended meanwhile
            var parent = int.Parse(fields[Parent], CultureInfo.InvariantCulture);
            var pages = long.Parse(fields[ResidentPages], CultureInfo.InvariantCulture);
            yield return (id, parent, pages * Environment.SystemPageSize);
        }
    }

    private static IEnumerable<int> Ids() => Directory.EnumerateDirectories("/proc").Select(Path.GetFileName)
        .Where(name => name!.All(char.IsAsciiDigit)).Select(name => int.Parse(name!, CultureInfo.InvariantCulture));

    private static byte[] Read(string path)
    {
        try
        {
            return File.ReadAllBytes(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return []; // the process has ended, or belongs to another user
        }
    }
}
