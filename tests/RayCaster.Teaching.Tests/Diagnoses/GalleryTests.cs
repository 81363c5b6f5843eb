using RayCaster.Teaching.Tests.Mistakes;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>docs/mistakes.md shows the catalogue as it is; RAYCASTER_ACCEPT=1 makes it again.</summary>
public class GalleryTests
{
    private static readonly bool accepts = Environment.GetEnvironmentVariable("RAYCASTER_ACCEPT") == "1";

    private const string Remedy =
        "RAYCASTER_ACCEPT=1 dotnet test --filter GalleryTests makes it anew (docs/adding-a-primitive.md has the command for Windows)";

    public static TheoryData<string> Ids => [.. MistakeCatalog.All.Select(mistake => mistake.Id)];

    [Fact]
    [Trait("kind", "campaign")]
    public void ThePageTellsTheCatalogue()
    {
        var page = Gallery.Page();
        if (accepts) File.WriteAllText(Gallery.File, page);
        var (expected, written) = (page.Split('\n'), File.ReadAllText(Gallery.File).ReplaceLineEndings("\n").Split('\n'));
        var first = expected.Zip(written).TakeWhile(pair => pair.First == pair.Second).Count();
        Assert.True(first == expected.Length && first == written.Length,
            $"docs/mistakes.md is not what the catalogue says from line {first + 1} on; {Remedy}");
    }

    [Theory]
    [Trait("kind", "campaign")]
    [MemberData(nameof(Ids))]
    public void ThePictureOfAMistakeIsWhatItDraws(string id)
    {
        var mistake = MistakeCatalog.Named(id)!;
        IsUpToDate(Gallery.PictureOf(mistake), Showcase.Of(mistake).Draw(mistake), id == "tri-area" ? 0.1 : 0.01);
    }

    [Fact]
    [Trait("kind", "campaign")]
    public void TheSheetShowsThemAll() => IsUpToDate(Gallery.SheetFile, Gallery.Sheet(), 0.01);

    [Fact]
    public void NoPictureIsLeftOver()
    {
        var files = Directory.GetFiles(Path.GetDirectoryName(Gallery.SheetFile)!).Select(file => Path.GetFileNameWithoutExtension(file)!);
        Assert.Empty(files.Except([.. MistakeCatalog.All.Select(mistake => mistake.Id), Path.GetFileNameWithoutExtension(Gallery.SheetFile)]));
    }

    /// <summary>The pixels are compared, not the files. A few may be turned by the last bits of another machine's tangent; of lace, more.</summary>
    private static void IsUpToDate(string file, Picture picture, double most)
    {
        if (accepts)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(file)!);
            PictureFile.Write(file, picture);
        }
        Assert.True(File.Exists(file), $"{file} is not there; {Remedy}");
        var written = PictureFile.Read(file);
        Assert.True((picture.Width, picture.Height) == (written.Width, written.Height)
            && ChangedPixels.Count(picture, written, levels: 2) <= most * picture.Width * picture.Height, $"{file} is out of date; {Remedy}");
    }
}
