namespace RayCaster.Tests.Pictures;

/// <summary>The scenes, as POV-Ray draws them from the same files by a converter that shares no code with this project.</summary>
public class ReferenceTests
{
    public static TheoryData<string> References => [.. Reference.Names];

    public static TheoryData<string> WithoutMeshes => [.. Reference.WithoutMeshes];

    [Theory]
    [MemberData(nameof(WithoutMeshes))]
    public void TheDefinitionsPictureIsTheOneThatPovRayDraws(string name) =>
        PictureAssert.Equal(name, ScalarRenderer.Render(Reference.SceneOf(name)));

    [Fact]
    public void EverySceneHasAReferenceOrAReasonForNone()
    {
        var without = File.ReadLines(Path.Combine(Reference.Folder, "inexpressible.txt")).Select(line => line.Split(' ')[0]);
        Assert.Equal(Reference.Scenes, Reference.Names.Concat(without).Order(StringComparer.Ordinal));
    }

    /// <summary>list.txt states for each scene how many pixels are on outlines, where the comparison is less strict; there must be few.</summary>
    [Theory]
    [MemberData(nameof(References))]
    public void OutlinesAreAsFewAsStatedAndAtMostTwoPixelsInAHundred(string name)
    {
        var reference = Reference.Read(Reference.Folder, name);
        var (width, height) = (reference.Picture.Width, reference.Picture.Height);
        var count = Enumerable.Range(0, width * height).Count(i => reference.IsOutline(i % width, i / width));
        var line = $"{name} {width}x{height} {count}";
        Assert.True(File.ReadLines(Path.Combine(Reference.Folder, "list.txt")).Contains(line),
            $"tests/References/list.txt lacks the line \"{line}\": a new reference needs one (docs/teaching.md), a changed one a new one");
        Assert.InRange(count, 0, width * height / 50);
    }
}
