namespace Lab.Tests;

/// <summary>The lab's own files, found from wherever the tests run.</summary>
public static class LabFolder
{
    /// <summary>The folder that the solution is in.</summary>
    public static string Root { get; } = Find();

    /// <summary>Where the scenes are.</summary>
    public static string Scenes { get; } = Path.Combine(Root, "scenes");

    /// <summary>The picture of a scene after a step.</summary>
    public static string Reference(string scene, int step) => Path.Combine(Scenes, $"step{step:00}", scene + ".png");

    private static string Find()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder.GetFiles("*.sln").Length == 0) folder = folder.Parent;
        return folder.FullName;
    }
}
