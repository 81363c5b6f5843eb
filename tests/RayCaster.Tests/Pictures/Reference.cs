namespace RayCaster.Tests.Pictures;

/// <summary>A picture that another program drew, and where it may be doubted (tests/References/README.md).</summary>
/// <param name="Picture">The picture.</param>
/// <param name="Outline">Not black where the colour hangs on a thousandth of a pixel; null if nowhere.</param>
internal sealed record Reference(Picture Picture, Picture? Outline)
{
    /// <summary>Where references are kept.</summary>
    public static string Folder => ProjectFolder.PathOf("tests/References");

    /// <summary>Where scenes are kept.</summary>
    public static string SceneFolder => ProjectFolder.PathOf("scenes");

    /// <summary>Reads a reference by its name, which is the scene's path under scenes without the extension.</summary>
    public static Reference Read(string folder, string name)
    {
        var outline = Path.Combine(folder, name + ".outline.png");
        return new(PictureFile.Read(Path.Combine(folder, name + ".png")), File.Exists(outline) ? PictureFile.Read(outline) : null);
    }

    /// <summary>Whether a pixel lies on an outline.</summary>
    public bool IsOutline(int x, int y) => Outline is not null && Outline[x, y].R != 0;
}
