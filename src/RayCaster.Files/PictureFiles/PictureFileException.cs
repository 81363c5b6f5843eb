namespace RayCaster.Files;

/// <summary>A picture file cannot be read or written, for a reason that a person can mend.</summary>
/// <param name="message">What was found, where, and what is allowed; lower-case, without a full stop, further lines indented.</param>
/// <param name="cause">What the system said, if it did.</param>
public sealed class PictureFileException(string message, Exception? cause = null) : Exception(message, cause)
{
    private const int NoSpaceOnUnix = 28, QuotaOnLinux = 122, QuotaOnMac = 69;
    private const int DiskFullOnWindows = unchecked((int)0x80070070);

    /// <summary>Whether the message says which file it is about.</summary>
    internal bool NamesFile { get; init; }

    /// <summary>Whether an exception is the system's way to say that a file cannot be used; the last is what a file comes to that grows too
    /// large.</summary>
    internal static bool IsCausedByFile(Exception e) => e is IOException or UnauthorizedAccessException or ArgumentOutOfRangeException;

    /// <summary>The system's reason in words; its own message would name the temporary file and end in a full stop.</summary>
    internal static string Reason(Exception e)
    {
        if (e is UnauthorizedAccessException) return "access is denied";
        if (e is FileNotFoundException or DirectoryNotFoundException) return "the file or its folder is gone";
        if (e is PathTooLongException) return "the name is too long";
        if (e.HResult is NoSpaceOnUnix or DiskFullOnWindows) return "the disk is full";
        if (e is ArgumentOutOfRangeException) return "the file is larger than the system allows";
        if (e.HResult == (OperatingSystem.IsMacOS() ? QuotaOnMac : QuotaOnLinux)) return "your disk quota is used up";
        var end = e.Message.IndexOf(" : '", StringComparison.Ordinal);
        var reason = (end < 0 ? e.Message : e.Message[..end]).TrimEnd('.');
        return reason.Length == 0 ? "the system gives no reason" : char.ToLowerInvariant(reason[0]) + reason[1..];
    }
}
