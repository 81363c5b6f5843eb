namespace RayCaster.Files;

/// <summary>Reads a short file in the form of a scene file: a rubric.</summary>
internal static class ShortFile
{
    /// <summary>The longest file, in bytes.</summary>
    public const int MaxBytes = 1 << 20;

    /// <summary>Reads a file, which may be a pipe that never ends. Returns null if there is an error.</summary>
    /// <param name="path">The file; messages name it as it is given here.</param>
    /// <param name="name">The name of the outermost object in messages.</param>
    /// <param name="report">All errors and warnings, as text for people; empty if there are none.</param>
    public static T? Read<T>(string path, string name, Func<SceneObject, T?> read, out string report) where T : class
    {
        if (InputBytes.ReadFile(path, "file", MaxBytes, "", out var utf8) is { } problem)
        {
            report = $"{path}: error: {problem}\n";
            return null;
        }
        var result = SceneReader.Parse(utf8, path, "", name, read, out var document);
        report = new SceneReading(null, document.Problems()).Report();
        return result;
    }
}
