using System.Formats.Tar;

namespace RayCaster.Files;

internal static class FileKind
{
    private const int TypeInHeader = 156; // the place of an archive's byte that says what an entry is

    /// <summary>Whether a file may replace what is at a path: nothing, a regular file, or a link to one.</summary>
    public static bool MayBeReplaced(string path)
    {
        if (OperatingSystem.IsWindows() || !File.Exists(path)) return true; // devices have names of their own on Windows
        var link = new FileInfo(path);
        var file = link.LinkTarget is null ? link : (FileInfo)link.ResolveLinkTarget(returnFinalTarget: true)!;
        if (!file.Exists) return false; // a link to something without a name, such as pipe:[123]
        return file.Length > 0 || IsEmptyFile(file); // devices have no length
    }

    /// <summary>Whether it is a file, not a device, pipe or socket. In the runtime only the class that makes archives finds this out without opening
    /// it; as a method of its own, because the runtime would load that library wherever this is compiled.</summary>
    private static bool IsEmptyFile(FileInfo file)
    {
        try
        {
            using var archive = new MemoryStream();
            using (var writer = new TarWriter(archive, TarEntryFormat.Ustar, leaveOpen: true)) writer.WriteEntry(file.FullName, "x");
            return archive.GetBuffer()[TypeInHeader] == (byte)TarEntryType.RegularFile;
        }
        catch (UnauthorizedAccessException)
        {
            return true; // only a regular file is opened for the archive, so this is one that may not be read
        }
        catch (IOException)
        {
            return false; // a socket, which no archive can hold
        }
    }
}
