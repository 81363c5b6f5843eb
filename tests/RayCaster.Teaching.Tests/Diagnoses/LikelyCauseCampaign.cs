using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Diagnoses.LikelyCauseTests;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Pictures of scenes with a wrong number in them: no mistake of the program makes these, and none may be accused.</summary>
public class LikelyCauseCampaign
{
    [Fact(Explicit = true)]
    public void AFartherTargetIsNoMistakeOfThePrograms()
    {
        var diagnosis = Of(room, Seen(room, target: new(-30, 0, 0)));
        Assert.DoesNotContain(diagnosis.Suspects, suspect => suspect.Mistakes.Count > 1);
        diagnosis = Of(generic, Seen(generic, target: generic.Camera.Position + 1.4 * (generic.Camera.Target - generic.Camera.Position)));
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.StartsWith("All outlines are right, only the light", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void AnotherFarPlaneIsNamedByItsNumber()
    {
        var diagnosis = Of(room, Seen(room, zFar: 20));
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.Contains("zFar is about 20", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void AModelsOtherColorIsNamed()
    {
        var ball = Model.Of(((Model<Sphere>)room.Models[5]).Primitive);
        (ball.Name, ball.Color) = ("ball", new(0.2, 0.9, 1));
        var diagnosis = Of(room, room with { Models = [.. room.Models.Select((model, i) => i == 5 ? ball : model)] });
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.StartsWith("`ball` has another colour", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void AnotherAngleIsToldAsASize()
    {
        var diagnosis = Of(generic, Seen(generic, fovY: 52));
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.StartsWith("The same picture, about 1.18 times too large: look at h", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void AnotherAngleThatTwoMistakesNearlyMakeIsToldAsASize()
    {
        var c = generic.Camera; // "nohalf" and "fov-horiz" make h = 2 tan(fovY) · height / width
        var chance = 360 / Math.PI * Math.Atan(Math.Tan(c.FovY * Math.PI / 180) * c.Height / c.Width);
        var diagnosis = Of(generic, Seen(generic, fovY: Math.Round(chance, 1)));
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.StartsWith("The same picture, about", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void TwoMistakesThatMakeAnotherAngleAreNamed()
    {
        Mistake[] both = [MistakeCatalog.Named("nohalf")!, MistakeCatalog.Named("fov-horiz")!];
        var diagnosis = Diagnosis.Of(generic, MistakeCatalog.Draw(generic, both));
        Assert.Equal(["fov-horiz", "nohalf"], diagnosis.Suspects[0].Mistakes.Select(mistake => mistake.Id).Order());
    }

    [Fact(Explicit = true)]
    public void BlackLinesAtABorderAreNoOtherLight()
    {
        var picture = ScalarRenderer.Render(generic);
        var half = picture.Height / 2;
        picture.Rgb.AsSpan(3 * picture.Width * half).Clear();
        var diagnosis = Diagnosis.Of(generic, picture);
        Assert.Equal(Finding.NoneOfThese, diagnosis.Finding);
        Assert.StartsWith($"Its {picture.Height - half} lower lines are black", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void ASmoothedPictureIsWrongOnlyOnItsOutlines()
    {
        var (right, smooth) = (ScalarRenderer.Render(generic), ScalarRenderer.Render(generic));
        for (var y = 1; y < right.Height - 1; y++)
            for (var x = 1; x < right.Width - 1; x++) smooth[x, y] = Mean(right[x - 1, y], right[x + 1, y], right[x, y - 1], right[x, y + 1]);
        var diagnosis = Diagnosis.Of(generic, smooth);
        Assert.Equal(Finding.NoneOfThese, diagnosis.Finding);
        Assert.StartsWith("Only outlines are wrong", Assert.Single(diagnosis.Likely));

        static (byte, byte, byte) Mean(params ReadOnlySpan<(byte R, byte G, byte B)> colors)
        {
            var (r, g, b) = (0, 0, 0);
            foreach (var color in colors) (r, g, b) = (r + color.R, g + color.G, b + color.B);
            return ((byte)(r / 4), (byte)(g / 4), (byte)(b / 4));
        }
    }

    [Fact(Explicit = true)]
    public void AnotherCameraIsToldByItsOutlines()
    {
        var diagnosis = Of(generic, Seen(generic, target: generic.Camera.Target + new Vector3(-1.5, 1.5, 0.8)));
        Assert.Equal(Finding.NoneOfThese, diagnosis.Finding);
        Assert.StartsWith("Its colours are those of the scene, but the outlines are others", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void TheOthersAreOrderedByWhatTheyLeave()
    {
        foreach (var id in new[] { "tri-uv", "u-unnorm" })
        {
            var rest = Diagnosis.Of(generic, EditedLab.Render(generic, Mistakes.Mistake.Named(id))).Suspects.Skip(1)
                .Select(suspect => suspect.Unexplained).ToArray();
            Assert.Equal(rest.Order(), rest);
        }
    }
}
