namespace RayCaster.Testing;

/// <summary>The system that the tests run on: the conditions under which a test is skipped.</summary>
internal static class Here
{
    public static bool IsLinux => OperatingSystem.IsLinux();

    public static bool IsWindows => OperatingSystem.IsWindows();

    /// <summary>Whether this user reads files and folders that nobody may read. Root does, unless the system has taken that from it.</summary>
    public static bool ReadsEverything
    {
        get
        {
            var file = Path.GetTempFileName();
            try
            {
                if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(file, UnixFileMode.None);
                File.ReadAllBytes(file);
                return true;
            }
            catch (UnauthorizedAccessException)
            {
                return false;
            }
            finally
            {
                File.Delete(file);
            }
        }
    }

    /// <summary>Whether the disk takes <c>A.txt</c> and <c>a.txt</c> for the same file.</summary>
    public static bool IgnoresCase => File.Exists(ProjectFolder.PathOf("raycaster.SLN"));
}
