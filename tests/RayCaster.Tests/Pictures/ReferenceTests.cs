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
        var expected = Reference.Names.Concat(without).ToArray();
        foreach (var name in Reference.Scenes.Except(expected))
            Assert.Fail($"scenes/{name}.json has no reference picture. If the scene is your own, move it to scenes/my. Otherwise draw "
                + $"tests/References/{name}.png with POV-Ray: tests/References/remake.sh {name}");
        foreach (var name in expected.Except(Reference.Scenes)) Assert.Fail($"tests/References has {name}, but scenes/{name}.json is missing");
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
