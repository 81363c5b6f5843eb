namespace RayCaster.Testing;

/// <summary>The system that the tests run on: the conditions under which a test is skipped.</summary>
internal static class Here
{
    public static bool IsLinux => OperatingSystem.IsLinux();

    public static bool IsWindows => OperatingSystem.IsWindows();

    /// <summary>Whether the disk takes <c>A.txt</c> and <c>a.txt</c> for the same file.</summary>
    public static bool IgnoresCase => File.Exists(ProjectFolder.PathOf("raycaster.SLN"));
}
