namespace RayCaster.Tests.Pictures;

/// <summary>The scenes, as POV-Ray draws them from the same files by a converter that shares no code with this project.</summary>
public class ReferenceTests
{
    /// <summary>The references, by name; a name may hold a folder.</summary>
    public static TheoryData<string> References => [.. Names];

    /// <summary>Those without a mesh, of which the definition would ask every triangle in every pixel.</summary>
    public static TheoryData<string> WithoutMeshes => [.. Names.Where(name => !File.ReadAllText(SceneFile(name)).Contains("\"mesh\""))];

    private static IEnumerable<string> Names => NamesIn(Reference.Folder, "*.png").Where(name => !Path.GetFileName(name).Contains('.'));

    [Theory]
    [MemberData(nameof(References))]
    public void ThePictureIsTheOneThatPovRayDraws(string name) => PictureAssert.Equal(name, Renderer.Render(SceneOf(name)));

    [Theory]
    [MemberData(nameof(WithoutMeshes))]
    public void TheDefinitionsPictureIsTheOneThatPovRayDraws(string name) =>
        PictureAssert.Equal(name, ScalarRenderer.Render(SceneOf(name)));

    /// <summary>A reference that half a pixel does not change would notice little else.</summary>
    [Theory]
    [MemberData(nameof(References))]
    public void EveryReferenceNoticesHalfAPixel(string name)
    {
        var scene = SceneOf(name);
        var c = scene.Camera;
        var other = c.Sample == Sample.Corner ? Sample.Center : Sample.Corner;
        var camera = new Camera(c.Position, c.Target, c.Up, c.FovY, c.Width, c.Height, c.ZNear, c.ZFar, c.Bias, c.Clip, other);
        var picture = Renderer.Render(scene with { Camera = camera });
        Assert.False(new ReferenceComparison(Reference.Read(Reference.Folder, name), picture).IsEqual);
    }

    [Fact]
    public void EverySceneHasAReferenceOrAReasonForNone()
    {
        var without = File.ReadLines(Path.Combine(Reference.Folder, "inexpressible.txt")).Select(line => line.Split(' ')[0]);
        var scenes = NamesIn(Reference.SceneFolder, "*.json").Where(name => name != "scene.schema");
        Assert.Equal(scenes, Names.Concat(without).Order(StringComparer.Ordinal));
    }

    /// <summary>list.txt states for each scene how many pixels are on outlines, where less is asked; there must not be many.</summary>
    [Theory]
    [MemberData(nameof(References))]
    public void OutlinesAreAsFewAsStatedAndAtMostTwoPixelsInAHundred(string name)
    {
        var reference = Reference.Read(Reference.Folder, name);
        var (width, height) = (reference.Picture.Width, reference.Picture.Height);
        var count = Enumerable.Range(0, width * height).Count(i => reference.IsOutline(i % width, i / width));
        Assert.Contains($"{name} {width}x{height} {count}", File.ReadLines(Path.Combine(Reference.Folder, "list.txt")));
        Assert.InRange(count, 0, width * height / 50);
    }

    /// <summary>The scene in the reference's size.</summary>
    private static Scene SceneOf(string name)
    {
        var scene = SceneReader.Read(SceneFile(name)).Scene!;
        var picture = Reference.Read(Reference.Folder, name).Picture;
        return scene with { Camera = scene.Camera.WithSize(picture.Width, picture.Height) };
    }

    private static string SceneFile(string name) => Path.Combine(Reference.SceneFolder, name + ".json");

    /// <summary>Paths below a folder, with / and without the extension, in order.</summary>
    private static IEnumerable<string> NamesIn(string folder, string pattern) => Directory
        .EnumerateFiles(folder, pattern, SearchOption.AllDirectories)
        .Where(file => !ProjectFolder.IsOwnScene(file))
        .Select(file => Path.ChangeExtension(Path.GetRelativePath(folder, file), null).Replace('\\', '/'))
        .Order(StringComparer.Ordinal);
}
