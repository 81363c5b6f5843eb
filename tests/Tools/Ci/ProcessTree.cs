using System.Diagnostics;

namespace RayCaster.Ci;

/// <summary>The processes of a job: those of its session, and what they have started. Linux only.</summary>
/// <param name="session">The number of the session, which is that of its first process.</param>
internal sealed class ProcessTree(int session)
{
    /// <summary>The greatest memory that a process has taken so far, in megabytes, as the system itself counts it.</summary>
    public int PeakMegabytes { get; private set; }

    /// <summary>Which process has taken it.</summary>
    public string PeakProgram { get; private set; } = "";

    /// <summary>Asks each process how much memory it has taken at most.</summary>
    public void Measure()
    {
        foreach (var process in Processes())
        {
            var line = Lines(process, "status").FirstOrDefault(line => line.StartsWith("VmHWM:", StringComparison.Ordinal)); // "VmHWM:  1234 kB"
            if (line is null || int.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[^2].Trim()) / 1024 is var megabytes
                && megabytes <= PeakMegabytes) continue;
            (PeakMegabytes, PeakProgram) = (megabytes, ProgramOf(process));
        }
    }

    /// <summary>Kills all of them.</summary>
    public void Kill()
    {
        for (var round = 0; round < 20 && Processes() is { Count: > 0 } processes; round++)
        {
            foreach (var process in processes)
            {
                try
                {
                    using var running = Process.GetProcessById(process);
                    running.Kill();
                }
                catch (Exception e) when (e is ArgumentException or InvalidOperationException or System.ComponentModel.Win32Exception)
                {
                    // it has ended, or is another user's
                }
            }
            Thread.Sleep(50);
        }
    }

    private List<int> Processes()
    {
        var all = new List<(int Id, int Parent, int Session)>();
        foreach (var folder in Directory.EnumerateDirectories("/proc"))
        {
            if (!int.TryParse(Path.GetFileName(folder), out var id)) continue;
            // "ID (NAME) STATE PARENT GROUP SESSION …", where the name may have blanks and parentheses
            var fields = string.Concat(Lines(id, "stat")).Split(')')[^1].Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (fields.Length > 3 && fields[0] is not ("Z" or "X")) all.Add((id, int.Parse(fields[1]), int.Parse(fields[3])));
        }
        var ours = all.Where(process => process.Session == session).Select(process => process.Id).ToHashSet();
        for (var found = -1; found < ours.Count;)
        {
            found = ours.Count;
            ours.UnionWith(all.Where(process => ours.Contains(process.Parent)).Select(process => process.Id).ToList());
        }
        return [.. ours];
    }

    private static string ProgramOf(int process)
    {
        var words = string.Concat(Lines(process, "cmdline")).Split('\0');
        var program = words.Length > 1 && words[0].EndsWith("dotnet", StringComparison.Ordinal)
            ? words.Skip(1).FirstOrDefault(word => word.EndsWith(".dll", StringComparison.Ordinal), words[0]) : words[0];
        return Path.GetFileName(program);
    }

    private static string[] Lines(int process, string file)
    {
        try
        {
            return File.ReadAllLines($"/proc/{process}/{file}");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return []; // it has ended
        }
    }
}
