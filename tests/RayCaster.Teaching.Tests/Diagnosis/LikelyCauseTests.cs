
namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>Pictures that no mistake of the program makes: none may be accused.</summary>
public class LikelyCauseTests
{
    private static readonly Scene room = SceneFolder.Small("room", 5), generic = SceneFolder.Small("mistakes/generic", 4);

    [Fact(Explicit = true)]
    public void AFartherTargetIsNoMistakeOfThePrograms() => Assert.DoesNotContain(
        DiagnosisResult.Find(room, ProgramInWords.Draw(room, "target -30 0 0"), new()).Suspects, suspect => suspect.Mistakes.Count > 1);

    [Fact(Explicit = true)]
    public void AModelsOtherColorIsNamed()
    {
        var ball = Model.Of(((Model<Sphere>)room.Models[5]).Primitive);
        (ball.Name, ball.Color) = ("ball", new(0.2, 0.9, 1));
        var other = room with { Models = [.. room.Models.Select((model, i) => i == 5 ? ball : model)] };
        var diagnosis = DiagnosisResult.Find(room, EditedLab.Render(other), new());
        Assert.Equal((DiagnosisKind.NoneOfThese, 0), (diagnosis.Kind, diagnosis.Suspects.Count));
        Assert.StartsWith("`ball` has another colour", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void BlackLinesAtABorderAreNoOtherLight()
    {
        var picture = ScalarRenderer.Render(generic);
        var half = picture.Height / 2;
        picture.Rgb.AsSpan(3 * picture.Width * half).Clear();
        var diagnosis = DiagnosisResult.Find(generic, picture, new());
        Assert.Equal(DiagnosisKind.NotTheFormulas, diagnosis.Kind);
        Assert.StartsWith($"The last {picture.Height - half} lines are (0, 0, 0)", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void ASmoothedPictureIsWrongOnlyOnItsOutlines()
    {
        var (right, smooth) = (ScalarRenderer.Render(generic), ScalarRenderer.Render(generic));
        for (var y = 1; y < right.Height - 1; y++)
            for (var x = 1; x < right.Width - 1; x++) smooth[x, y] = Mean(right[x - 1, y], right[x + 1, y], right[x, y - 1], right[x, y + 1]);
        var diagnosis = DiagnosisResult.Find(generic, smooth, new());
        Assert.Equal(DiagnosisKind.NoneOfThese, diagnosis.Kind);
        Assert.StartsWith("Only outlines are wrong", Assert.Single(diagnosis.Likely));

        static (byte, byte, byte) Mean(params ReadOnlySpan<(byte R, byte G, byte B)> colors)
        {
            var (r, g, b) = (0, 0, 0);
            foreach (var color in colors) (r, g, b) = (r + color.R, g + color.G, b + color.B);
            return ((byte)(r / 4), (byte)(g / 4), (byte)(b / 4));
        }
    }

    [Fact(Explicit = true)]
    public void TheOthersAreOrderedByWhatTheyLeave()
    {
        foreach (var id in new[] { "tri-uv", "u-unnorm" })
        {
            var rest = DiagnosisResult.Find(generic, EditedLab.Render(generic, PlantedMistake.Named(id)), new()).Suspects.Skip(1)
                .Select(suspect => suspect.Unexplained).ToArray();
            Assert.Equal(rest.Order(), rest);
        }
    }
}
