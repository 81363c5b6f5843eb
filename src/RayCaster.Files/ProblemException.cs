namespace RayCaster.Files;

/// <summary>Something that the user can mend: a wrong command line, a file that cannot be read or written. Only the message is printed.</summary>
/// <param name="message">What was found, where, and what is allowed; lower-case, without a full stop, further lines indented.</param>
/// <param name="cause">The system's exception, if there is one.</param>
public sealed class ProblemException(string message, Exception? cause = null) : Exception(message, cause)
{
    private const int NoSpaceOnUnix = 28, QuotaOnLinux = 122, QuotaOnMac = 69;
    private const int DiskFullOnWindows = unchecked((int)0x80070070), SharingViolation = unchecked((int)0x80070020);

    internal const string OpenElsewhere = "another program has it open; close it there";

    /// <summary>Whether the command line is wrong: then the command's usage is printed, too.</summary>
    public bool IsUsage { get; private init; }

    /// <summary>Whether the message names the file.</summary>
    public bool NamesFile { get; init; }

    /// <summary>The line of a text at which the message belongs behind the file's name; 0 for none.</summary>
    internal int Line { get; init; }

    /// <summary>A problem in the command line.</summary>
    public static ProblemException Usage(string message) => new(message) { IsUsage = true };

    /// <summary>Whether the system throws such an exception for a file or folder that cannot be used; the last kind is for a file that grows too
    /// large.</summary>
    public static bool IsCausedByFile(Exception e) =>
        e is IOException or UnauthorizedAccessException
        || e is ArgumentOutOfRangeException { ParamName: "value" } && e.Message.StartsWith("Specified file length", StringComparison.Ordinal);

    /// <summary>The problem that the system has with a file, without the file's name.</summary>
    internal static ProblemException From(Exception cause) => new(Reason(cause), cause);

    /// <summary>The system's reason in words. Its own message names the temporary file and ends in a full stop.</summary>
    internal static string Reason(Exception e)
    {
        if (e is UnauthorizedAccessException) return "access is denied";
        if (e is FileNotFoundException or DirectoryNotFoundException) return "the file or its folder does not exist";
        if (e.HResult == SharingViolation) return OpenElsewhere;
        if (e is PathTooLongException) return "the name is too long";
        if (e.HResult is NoSpaceOnUnix or DiskFullOnWindows) return "the disk is full";
        if (e is ArgumentOutOfRangeException) return "the file is larger than the system allows";
        if (e.HResult == (OperatingSystem.IsMacOS() ? QuotaOnMac : QuotaOnLinux)) return "your disk quota is used up";
        var end = e.Message.IndexOf(" : '", StringComparison.Ordinal);
        var reason = (end < 0 ? e.Message : e.Message[..end]).TrimEnd('.');
        return reason.Length == 0 ? "the system gives no reason" : char.ToLowerInvariant(reason[0]) + reason[1..];
    }
}
