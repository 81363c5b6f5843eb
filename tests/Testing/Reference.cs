using System.Collections.Concurrent;

namespace RayCaster.Testing;

/// <summary>A picture that another program drew, and the pixels in which it is uncertain (tests/References/README.md).</summary>
/// <param name="Picture">The picture.</param>
/// <param name="Outline">Not black where the colour hangs on a thousandth of a pixel; null if nowhere.</param>
internal sealed record Reference(Picture Picture, Picture? Outline)
{
    private static readonly ConcurrentDictionary<string, Reference> read = new();

    /// <summary>Where references are kept.</summary>
    public static string Folder => ProjectFolder.PathOf("tests/References");

    /// <summary>All references by name; a name may hold a folder.</summary>
    public static IEnumerable<string> Names => Directory.EnumerateFiles(Folder, "*.png", SearchOption.AllDirectories)
        .Select(file => Path.ChangeExtension(Path.GetRelativePath(Folder, file), null).Replace('\\', '/'))
        .Where(name => !Path.GetFileName(name).Contains('.')).Order(StringComparer.Ordinal);

    /// <summary>Those without a mesh, of which the definition would ask every triangle in every pixel.</summary>
    public static IEnumerable<string> WithoutMeshes => Names.Where(name => !File.ReadAllText(SceneFolder.FileOf(name)).Contains("\"mesh\""));

    /// <summary>A reference's scene, in the reference's size.</summary>
    public static Scene SceneOf(string name)
    {
        var scene = SceneFolder.Read(SceneFolder.FileOf(name));
        var picture = Of(name).Picture;
        return scene.WithSize(picture.Width, picture.Height);
    }

    /// <summary>The same with rays half a pixel farther up and to the right, or back.</summary>
    public static Scene HalfAPixelAway(Scene scene)
    {
        var other = scene.Camera.Sample == PixelSample.Corner ? PixelSample.Center : PixelSample.Corner;
        return scene with { Camera = scene.Camera with { Sample = other } };
    }

    /// <summary>A reference by its name, which is the scene's path under scenes without the extension.</summary>
    public static Reference Of(string name) => read.GetOrAdd(name, name => Read(Folder, name));

    /// <summary>Reads a reference of any folder.</summary>
    public static Reference Read(string folder, string name)
    {
        var outline = Path.Combine(folder, name + ".outline.png");
        return new(PictureFile.Read(Path.Combine(folder, name + ".png")), File.Exists(outline) ? PictureFile.Read(outline) : null);
    }

    /// <summary>Whether a pixel lies on an outline.</summary>
    public bool IsOutline(int x, int y) => Outline is not null && Outline[x, y].R != 0;
}
