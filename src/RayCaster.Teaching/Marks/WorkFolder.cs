using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>A new folder for one run of a student's program; deleted afterwards with all its content.</summary>
internal sealed class WorkFolder : IDisposable
{
    private const int MaxDepth = 64;

    private static readonly EnumerationOptions foldersInIt =
        new() { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint, MaxRecursionDepth = MaxDepth };

    private readonly string path = Directory.CreateTempSubdirectory("raycaster-").FullName;

    public WorkFolder()
    {
        foreach (var folder in (string[])[Files, Scene, Root]) Directory.CreateDirectory(folder);
    }

    /// <summary>The folder for the program's files: its home, its temporary files and its pictures.</summary>
    public string Files => Path.Combine(path, "work");

    /// <summary>The folder for a scene and its meshes, which the program only reads.</summary>
    public string Scene => Path.Combine(path, "scene");

    private string Root => Path.Combine(path, "root");

    /// <summary>Where a program runs with this folder.</summary>
    /// <param name="current">Its current folder.</param>
    /// <param name="own">The submission's folder, if not the current one.</param>
    public ProgramPlace Place(string current, string? own = null, params IReadOnlyList<string> readable) =>
        new(current, Files, Root, [own ?? current, Files], [Scene, .. readable]);

    /// <summary>Copies a scene and its meshes into the folder, and nothing else of what lies beside it.</summary>
    /// <returns>The scene's path.</returns>
    public string Copy(MarkedScene scene)
    {
        var tree = JsonTree.Parse(new SourceText("", scene.Text), out _)!;
        var edits = new List<(JsonValue, string)>();
        foreach (var (number, model) in (tree.Root.Find("models")?.Content ?? []).Index())
        {
            if (model.Find("file") is not { Kind: JsonTokenType.String } file) continue;
            var name = $"{number}{Path.GetExtension(file.Text)}";
            File.Copy(Path.Combine(Path.GetDirectoryName(scene.Path)!, file.Text.Replace('\\', '/')), Path.Combine(Scene, name));
            edits.Add((file, $"\"{JsonEncodedText.Encode(name)}\""));
        }
        var path = Path.Combine(Scene, scene.Name + ".json");
        File.WriteAllBytes(path, tree.With(edits));
        return path;
    }

    /// <summary>Copies files into a new folder for the program; of two with one name the second stays.</summary>
    /// <returns>The folder's path.</returns>
    public string Copy(IEnumerable<string> files, string folder)
    {
        var target = Directory.CreateDirectory(Path.Combine(Files, folder)).FullName;
        foreach (var file in files) File.Copy(file, Path.Combine(target, Path.GetFileName(file)), overwrite: true);
        return target;
    }

    /// <summary>Deletes the folder. Files that cannot be deleted stay in the system's folder for temporary files.</summary>
    public void Dispose()
    {
        try
        {
            for (var number = 0; FindDeepFolder() is { } deep; number++) Directory.Move(deep, Path.Combine(path, $"deep-{number}"));
            Directory.Delete(path, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
        }
    }

    /// <summary>A folder so deep that paths in it may be too long for the system; null if there is none.</summary>
    private string? FindDeepFolder() => Directory.EnumerateDirectories(path, "*", foldersInIt)
        .FirstOrDefault(folder => folder.AsSpan(path.Length).Count(Path.DirectorySeparatorChar) > MaxDepth);
}
