namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>Pictures whose fault is in no formula: pixels that no loop reached, one colour.</summary>
public class NotTheFormulasTests
{
    private static readonly Scene room = SceneFolder.Small("room", 5), generic = SceneFolder.Small("mistakes/generic", 4);

    [Theory]
    [InlineData("room", "last line and column", "The last line and the last column are (0, 0, 0): does your loop reach them?")]
    [InlineData("generic", "border of 3", "The first 3 and the last 3 lines and the first 3 and the last 3 columns are (0, 0, 0)")]
    [InlineData("room", "every second line", "The lines 1, 3, 5, 7 … from the top are (0, 0, 0)")]
    [InlineData("generic", "right half", "columns are (0, 0, 0): does your loop reach them?")]
    public void PixelsThatNoLoopReachedAreTold(string name, string which, string says)
    {
        var diagnosis = DiagnosisResult.Find(SceneOf(name), Spoilt(Renderer.Render(SceneOf(name)), which), new());
        Assert.Equal((DiagnosisKind.NotTheFormulas, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        Assert.Contains(says, Assert.Single(diagnosis.Likely));
    }

    [Fact]
    public void OneUnreachedLineIsAKnownMistake()
    {
        var diagnosis = DiagnosisResult.Find(room, Spoilt(Renderer.Render(room), "last line"), new());
        Assert.Equal("row-off", diagnosis.Suspects[0].Mistakes.Single().Id);
    }

    [Fact]
    public void AMistakeBesideUnreachedLinesIsStillNamed()
    {
        var diagnosis = DiagnosisResult.Find(generic, Spoilt(EditedLab.Render(generic, PlantedMistake.Named("tri-uv")), "border of 3"), new());
        Assert.Equal("tri-uv", string.Join(" + ", diagnosis.Suspects[0].Mistakes.Select(mistake => mistake.Id)));
        Assert.StartsWith("The first 3 and the last 3 lines", diagnosis.Likely[0]);
    }

    [Theory]
    [InlineData(0, 0, "is all black, (0, 0, 0)")]
    [InlineData(255, 0, "is all white, (255, 255, 255)")]
    [InlineData(96, 1, "but for a level or two")]
    public void APictureOfNearlyOneColourProvesNothing(int level, int more, string says)
    {
        var right = Renderer.Render(room);
        var picture = Picture.Create(right.Width, right.Height, (x, y) => Grey((byte)(level + (x * y % 3 == 0 ? more : 0))));
        var diagnosis = DiagnosisResult.Find(room, picture, new());
        Assert.Equal((DiagnosisKind.TellsNothing, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        var compared = ComparisonText.Format(new PictureComparison(picture, right, room), "mine.png", "right.png");
        Assert.Contains(says, compared);
    }

    [Fact]
    public void ARightPictureOfOneColourIsNotAccused()
    {
        var wall = new Scene(new Camera(new(20, 0, 0), Vector3.Zero) { FovY = 3, Width = 20, Height = 20 },
            [new Model<Plane>(new(new(-5, 0, 0), new(1, 0, 0)))]);
        var diagnosis = DiagnosisResult.Find(wall, Renderer.Render(wall), new());
        Assert.Equal(DiagnosisKind.Matches, diagnosis.Kind);
        Assert.True(diagnosis.ProvesNothing);
    }

    private static Scene SceneOf(string name) => name == "room" ? room : generic;

    private static (byte, byte, byte) Grey(byte level) => (level, level, level);

    private static Picture Spoilt(Picture picture, string which)
    {
        var (width, height) = (picture.Width, picture.Height);
        return Picture.Create(width, height, (x, y) => which switch
        {
            "last line" when y == height - 1 => default,
            "last line and column" when y == height - 1 || x == width - 1 => default,
            "border of 3" when x < 3 || x >= width - 3 || y < 3 || y >= height - 3 => default,
            "every second line" when y % 2 == 1 => default,
            "right half" when x >= width / 2 => default,
            _ => picture[x, y],
        });
    }
}
