using RayCaster.Files.Tests.Pictures;

namespace RayCaster.Files.Tests.Parts;

public sealed class PartFileTests : InTemporaryFolder
{
    private static readonly PartFacts Facts = new(7, 90, new(10, 14), "0123456789abcdef", "1.0.0");

    [Fact]
    public void APartIsAnOrdinaryPngThatSaysWhatItIsPartOf()
    {
        var path = Write(Facts);
        var picture = PictureFile.Read(path);
        Assert.Equal((7, 5), (picture.Width, picture.Height));
        Assert.Equal(Pixels(5), picture.Rgb);
        Assert.Equal(Facts, PartFile.FactsOf(path));
        Assert.Contains("tEXtraycaster:part\0picture 7x90\nlines 10..14\nscene 0123456789abcdef\nraycaster 1.0.0\n",
            System.Text.Encoding.Latin1.GetString(File.ReadAllBytes(path)));
    }

    [Fact]
    public void APictureIsNoPart() => Assert.Null(PartFile.FactsOf(ProjectFolder.PathOf("docs/room.png")));

    [Fact]
    public void WhatItSaysMustBeTrueAndKnown()
    {
        Refused(Write(Facts, lines: 4),
            "it says that it holds the lines 10..14, each of 7 pixels, but has 4 lines of 7: it was changed by another program");
        Refused(Write(Facts with { Digest = "a\nb" }), "its text about its part of the picture is unknown; perhaps a newer raycaster drew it");
        Refused(folder.Write("a.png", "P6 1 1 255 abc"), "it is not a PNG");
        File.WriteAllBytes(folder["b.png"], TestPng.Png(TestPng.Header(1, -1, 8, 2)));
        Refused(folder["b.png"], "it has 4,294,967,295 lines, the limit is 2,147,483,647");

        static void Refused(string path, string message) =>
            Assert.Equal($"cannot read {path}: {message}", Assert.Throws<ProblemException>(() => PartFile.FactsOf(path)).Message);
    }

    [Fact]
    public void AFileThatHoldsJustThisNeedNotBeDrawnAgain()
    {
        Assert.False(PartFile.Holds(folder["part.png"], Facts, out _));
        Assert.True(PartFile.Holds(Write(Facts), Facts, out _));
    }

    [Fact]
    public void AnotherPartIsDrawnAgain()
    {
        PartFacts[] others =
        [
            Facts with { Width = 8 }, Facts with { Height = 91 }, Facts with { Lines = new(11, 15) }, Facts with { Digest = "0" },
            Facts with { Version = "1.0.1" },
        ];
        Assert.All(others, other => Assert.False(PartFile.Holds(Write(Facts), other, out _)));
    }

    [Fact]
    public void ADamagedPartIsDrawnAgainWhereverItIsDamaged()
    {
        var bytes = File.ReadAllBytes(Write(Facts));
        for (var i = 0; i < bytes.Length; i++)
        {
            bytes[i] ^= 1;
            Assert.False(PartFile.Holds(folder.Write("damaged.png", bytes), Facts, out _), $"byte {i}");
            bytes[i] ^= 1;
            Assert.False(PartFile.Holds(folder.Write("cut.png", bytes[..i]), Facts, out _), $"cut at byte {i}");
        }
    }

    /// <summary>A formula that was edited makes another assembly, with a module version id of its own.</summary>
    [Fact]
    public void AnotherBuildOfTheProgramIsAnotherVersion()
    {
        System.Reflection.Assembly library = typeof(Scene).Assembly, files = typeof(PartFacts).Assembly;
        Assert.Matches(@"^\d+\.\d+\.\d+\+[0-9a-f]{12}$", PartFacts.VersionOf(library, files));
        Assert.Equal(PartFacts.VersionOf(library, files), PartFacts.VersionOf(library, files));
        Assert.NotEqual(PartFacts.VersionOf(library, files), PartFacts.VersionOf(library, typeof(PartFileTests).Assembly));
        var (scene, lines) = (new Scene(new(new(5, 0, 0), Vector3.Zero), []), NumberRange.Whole(500));
        var (mine, edited) = (PartFacts.Create(scene, lines, "", files), PartFacts.Create(scene, lines, "", typeof(PartFileTests).Assembly));
        Assert.False(PartFile.Holds(Write(mine, width: 500), edited, out var reason));
        Assert.Equal($"it was drawn by version {mine.Version}, and this is {edited.Version}", reason);
    }

    private static byte[] Pixels(int lines, int width = 7)
    {
        var rgb = new byte[width * 3 * lines];
        new Random(1).NextBytes(rgb);
        return rgb;
    }

    private string Write(PartFacts facts, int? lines = null, int width = 7)
    {
        using var output = new MemoryStream();
        using var writer = PictureWriter.Create(PictureFormat.Png, output, width, lines ?? facts.Lines.Count, facts.PngText);
        writer.WriteRows(Pixels(lines ?? facts.Lines.Count, width));
        writer.Finish();
        return folder.Write("part.png", output.ToArray());
    }
}
