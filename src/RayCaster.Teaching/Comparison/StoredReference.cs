namespace RayCaster.Teaching.Comparison;

/// <summary>
/// Checks whether this build still draws a scene like its stored reference picture. If a change in the course library has changed the picture,
/// this build cannot judge other pictures.
/// </summary>
public static class StoredReference
{
    /// <summary>The most pixels that are drawn for the comparison.</summary>
    private const long MaxPixels = 1_000_000;

    /// <summary>A message, without a full stop, if this build's own picture of a scene is not the stored one; null if it is, or if there is
    /// none.</summary>
    /// <param name="path">The scene's file. The reference of <c>scenes/room.json</c> is <c>tests/References/room.png</c>.</param>
    /// <exception cref="ProblemException">The reference cannot be read.</exception>
    public static string? Contradiction(string path, Scene scene)
    {
        if (Find(path) is not { } file) return null;
        var reference = PictureFile.Read(file);
        if ((long)reference.Width * reference.Height > MaxPixels) return null;
        var right = Renderer.Render(scene.WithSize(reference.Width, reference.Height));
        return new PictureComparison(right, reference).Likeness.IsSame() ? null
            : $"src/RayCaster has been changed: this build's own picture of {path} is not {Path.GetRelativePath(".", file)}";
    }

    /// <summary>The reference of a scene in a folder "scenes", whose neighbour is "tests/References".</summary>
    private static string? Find(string path)
    {
        var full = Path.GetFullPath(path);
        for (var folder = Path.GetDirectoryName(full); folder is not null; folder = Path.GetDirectoryName(folder))
        {
            if (Path.GetFileName(folder) != "scenes") continue;
            var name = Path.ChangeExtension(Path.GetRelativePath(folder, full), ".png");
            var reference = Path.Combine(folder, "..", "tests", "References", name);
            return File.Exists(reference) ? Path.GetFullPath(reference) : null;
        }
        return null;
    }
}
