using System.Security.Cryptography;

namespace RayCaster.Teaching;

/// <summary>
/// The key with which finished marks are signed, so that no student's program can forge them. It is in a file of the user's own data, which only
/// the user can read, and which programs do not see where files can be hidden from them.
/// </summary>
internal static class MarksKey
{
    private const int Length = 32;

    /// <summary>The key's file; null if the user has no folder for data.</summary>
    public static string? File { get; } = Environment.GetFolderPath(
        Environment.SpecialFolder.LocalApplicationData, Environment.SpecialFolderOption.DoNotVerify) is { Length: > 0 } folder
        ? Path.Combine(folder, "raycaster", "marks.key") : null;

    /// <summary>The key. It is made at first use; where it cannot be stored, the next run has another one and marks everything anew.</summary>
    public static byte[] Read()
    {
        var key = RandomNumberGenerator.GetBytes(Length);
        if (File is null) return key;
        if (RegularFile.Read(File, Length) is { Length: Length } old) return old;
        try
        {
            Directory.CreateDirectory(Path.GetDirectoryName(File)!);
            var options = new FileStreamOptions { Mode = FileMode.Create, Access = FileAccess.Write };
            if (!OperatingSystem.IsWindows()) options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
            using var file = new FileStream(File, options);
            file.Write(key);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
        }
        return key;
    }

    /// <summary>A signature of bytes.</summary>
    public static string Sign(byte[] key, ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(HMACSHA256.HashData(key, bytes));
}
