using System.Globalization;

namespace RayCaster.Teaching;

/// <summary>The processes that descend from one, as Linux tells them; elsewhere only the one itself is known.</summary>
internal static class ProcessTree
{
    private const int Parent = 1, ResidentPages = 21; // places in /proc/N/stat after the name

    /// <summary>How many processes descend from one, itself included, and how many bytes of memory they hold together.</summary>
    /// <param name="root">The process.</param>
    public static (int Processes, long Memory) Measure(int root)
    {
        if (!OperatingSystem.IsLinux()) return (1, 0);
        var children = new Dictionary<int, List<(int Id, long Memory)>>();
        foreach (var (id, parent, memory) in All())
        {
            if (!children.TryGetValue(parent, out var siblings)) children.Add(parent, siblings = []);
            siblings.Add((id, memory));
        }
        var (processes, sum) = (1, 0L);
        var open = new Stack<int>([root]);
        while (open.TryPop(out var parent))
        {
            if (!children.Remove(parent, out var siblings)) continue; // removed, so that a number used anew makes no circle
            foreach (var (id, memory) in siblings)
            {
                (processes, sum) = (processes + 1, sum + memory);
                open.Push(id);
            }
        }
        return (processes, sum);
    }

    /// <summary>How many processes and threads the whole system has: one short read, fit to be done often. 0 where it is not told.</summary>
    public static int TaskCount()
    {
        if (!OperatingSystem.IsLinux()) return 0;
        var words = System.Text.Encoding.ASCII.GetString(Read("/proc/loadavg")).Split(' ', '/'); // 0.20 0.18 0.12 1/80 11206
        return words.Length > 4 && int.TryParse(words[4], NumberStyles.None, CultureInfo.InvariantCulture, out var count) ? count : 0;
    }

    /// <summary>The processes that have a variable with this value in the environment that they were started with.</summary>
    public static IEnumerable<int> WithVariable(string name, string value)
    {
        if (!OperatingSystem.IsLinux()) yield break;
        var sought = System.Text.Encoding.UTF8.GetBytes($"{name}={value}\0");
        foreach (var id in Ids())
            if (Read($"/proc/{id}/environ").AsSpan().IndexOf(sought) >= 0)
                yield return id;
    }

    private static IEnumerable<(int Id, int Parent, long Memory)> All()
    {
        foreach (var id in Ids())
        {
            var stat = System.Text.Encoding.ASCII.GetString(Read($"/proc/{id}/stat"));
            var fields = stat[(stat.LastIndexOf(')') + 1)..].Split(' ', StringSplitOptions.RemoveEmptyEntries); // the name may hold anything
            if (fields.Length <= ResidentPages) continue; // it has ended meanwhile
            var parent = int.Parse(fields[Parent], CultureInfo.InvariantCulture);
            var pages = long.Parse(fields[ResidentPages], CultureInfo.InvariantCulture);
            yield return (id, parent, pages * Environment.SystemPageSize);
        }
    }

    private static IEnumerable<int> Ids()
    {
        foreach (var folder in Directory.EnumerateDirectories("/proc"))
            if (int.TryParse(Path.GetFileName(folder), NumberStyles.None, CultureInfo.InvariantCulture, out var id))
                yield return id;
    }

    private static byte[] Read(string path)
    {
        try
        {
            return File.ReadAllBytes(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return []; // it has ended, or belongs to somebody else
        }
    }
}
