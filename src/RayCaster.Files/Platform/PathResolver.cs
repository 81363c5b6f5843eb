using System.Formats.Tar;

namespace RayCaster.Files;

/// <summary>Follows links, and tells files from devices, pipes and what the process has open.</summary>
public static class PathResolver
{
    private const int MaxLinks = 40; // as many as Linux follows

    private static readonly char[] separators = [Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar];

    /// <summary>The full path that a path leads to, without links; of a link that leads nowhere, the file that it names. Null if links lead in a
    /// circle.</summary>
    internal static string? Resolve(string path)
    {
        var place = "";
        var names = new Stack<string>();
        var links = 0;
        Go(Path.GetFullPath(path));
        while (names.TryPop(out var name))
        {
            var next = name == ".." ? Path.GetDirectoryName(place) ?? place : Path.Join(place, name);
            if (name is "" or ".") continue;
            if (name == ".." || IsOpen(next) || new FileInfo(next).LinkTarget is not { } target) place = next;
            else if (++links > MaxLinks) return null;
            else Go(target);
        }
        return place;

        void Go(string to)
        {
            var root = Path.GetPathRoot(to) ?? "";
            if (root.Length > 0) place = root;
            foreach (var name in to[root.Length..].Split(separators).Reverse()) names.Push(name);
        }
    }

    /// <summary>This program's folder, or the nearest above it, that holds a file, as a clone of the repository does; null if none does.</summary>
    public static string? FolderWith(string file)
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, file))) folder = folder.Parent;
        return folder?.FullName;
    }

    /// <summary>Whether a place holds a file, or nothing: false for a pipe, a device, a socket, and for what a process has open.</summary>
    /// <param name="place">A path without links.</param>
    internal static bool IsFileOrFree(string place)
    {
        if (IsOpen(place)) return false;
        return OperatingSystem.IsWindows() || new FileInfo(place) is not { Exists: true, Length: 0 } || IsRegular(place);
    }

    // The runtime says what an empty path is only when it is put into an archive. A method of its own, so that others do not load the library.
    private static bool IsRegular(string place)
    {
        try
        {
            var archive = new MemoryStream();
            using (var writer = new TarWriter(archive, TarEntryFormat.Gnu, leaveOpen: true)) writer.WriteEntry(place, "place");
            archive.Position = 0;
            return new TarReader(archive).GetNextEntry()!.EntryType == TarEntryType.RegularFile;
        }
        catch (Exception e) // whatever the library throws
        {
            return e is UnauthorizedAccessException; // it opens files only; otherwise it is a socket
        }
    }

    /// <summary>The number by which this process has a place open: 1 for <c>/dev/stdout</c>; null for any other.</summary>
    internal static int? DescriptorOf(string place)
    {
        var folder = Path.GetDirectoryName(place);
        return IsOpen(place) && (folder == "/dev/fd" || folder == $"/proc/{Environment.ProcessId}/fd")
            ? int.Parse(Path.GetFileName(place), CultureInfo.InvariantCulture)
            : null;
    }

    /// <summary>Whether a name is that of a device on Windows, in any folder and with any extension: <c>aux.png</c>.</summary>
    internal static bool IsDeviceOnWindows(string name) => name.Split('.')[0].TrimEnd(' ').ToUpperInvariant() switch
    {
        "CON" or "PRN" or "AUX" or "NUL" or "CONIN$" or "CONOUT$" => true,
        ['C', 'O', 'M', (>= '1' and <= '9') or '¹' or '²' or '³'] or ['L', 'P', 'T', (>= '1' and <= '9') or '¹' or '²' or '³'] => true,
        _ => false,
    };

    // Links of these places need not name a file: pipe:[4711].
    private static bool IsOpen(string place) =>
        (place.StartsWith("/dev/fd/", StringComparison.Ordinal) || place.StartsWith("/proc/", StringComparison.Ordinal))
        && Path.GetFileName(Path.GetDirectoryName(place)) == "fd"
        && int.TryParse(Path.GetFileName(place), NumberStyles.None, CultureInfo.InvariantCulture, out _);
}
