using System.Text.RegularExpressions;

namespace RayCaster.Cli;

/// <summary>Writes a hand-out: a folder that is a course's repository. The folder is written completely or not at all.</summary>
internal static partial class HandOutFolder
{
    public static void Write(string folder, Func<int, bool> isOpen)
    {
        var target = PathResolver.Resolve(folder) ?? Path.GetFullPath(folder);
        if (File.Exists(target) || (Directory.Exists(target) && Directory.EnumerateFileSystemEntries(target).Any()))
            throw new ProblemException($"{folder} exists already, and is not empty\n  Name a new folder: handout overwrites nothing.");
        if (Misread().Match(target[Path.GetPathRoot(target)!.Length..].Replace(Path.DirectorySeparatorChar, '/')) is { Success: true } part)
            throw new ProblemException($"{folder} could not be built: MSBuild misreads '{part}' in a path, as in {target}\n" +
                "  Name another folder: its path must not have % before two digits or letters from A to F, nor @(, ..., *, ?, :, \\ or \".");
        ThrowIfPicturesDiffer();
        var files = HandOutFiles.With(isOpen);
        AtomicFile.WriteFolder(folder, made =>
        {
            foreach (var (path, content) in files) AtomicFile.WriteInFolder(Path.Combine(made, path), content);
            CarriedTool.Copy(Path.Combine(made, "lib"));
            WritePictures(Path.Combine(made, "scenes"));
        });
    }

    /// <summary>What MSBuild takes in a path for the code of a character, a list of items, a pattern, a drive, a separator or a quote.</summary>
    [GeneratedRegex(@"%[0-9A-Fa-f]{2}|@\(|\.\.\.|[*?:\\""]")]
    private static partial Regex Misread();

    /// <summary>A hand-out judges students by the pictures of this build: in a clone they must be the stored references.</summary>
    private static void ThrowIfPicturesDiffer()
    {
        if (PathResolver.FolderWith("RayCaster.sln") is not { } clone) return;
        foreach (var file in Directory.GetFiles(Path.Combine(clone, "scenes"), "*.json", SearchOption.AllDirectories))
        {
            if (SceneReader.Read(file).Scene is { } scene && StoredReference.Contradiction(file, scene) is { } difference)
                throw new ProblemException($"{difference}, and a hand-out would judge by it\n  Undo the change in src/RayCaster.");
        }
    }

    /// <summary>The picture of each scene after each step, as scenes/step07/room.png.</summary>
    private static void WritePictures(string scenes)
    {
        foreach (var file in Directory.GetFiles(scenes, "*.json", SearchOption.AllDirectories))
        {
            if (file.EndsWith(".schema.json")) continue;
            var reading = SceneReader.Read(file);
            var scene = reading.Scene ?? throw new ProblemException($"a scene of the hand-out has errors\n{reading.Report()}");
            using var png = new MemoryStream();
            for (var step = 1; step <= LabSteps.Count; step++)
            {
                if (LabSteps.Changes(scene, step))
                {
                    png.SetLength(0);
                    PictureFile.Write(png, LabSteps.Draw(scene, step), PictureFormat.Png);
                }
                var picture = Path.Combine(scenes, $"step{step:00}", Path.ChangeExtension(Path.GetRelativePath(scenes, file), ".png"));
                AtomicFile.WriteInFolder(picture, png.ToArray());
            }
        }
    }
}
