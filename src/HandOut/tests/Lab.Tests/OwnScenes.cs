namespace Lab.Tests;

/// <summary>Scenes of the course's own: scenes/my/NAME.json with a picture NAME.png beside it, from any program, is tested like the
/// others.</summary>
[Trait("step", "10")]
public class OwnScenes : StepTests
{
    [Fact]
    public void EachIsThePictureBesideIt()
    {
        var folder = Path.Combine(LabFolder.Scenes, "my");
        if (!Directory.Exists(folder)) return;
        foreach (var picture in Directory.EnumerateFiles(folder, "*.png"))
            if (Path.ChangeExtension(picture, ".json") is var scene && File.Exists(scene))
                PictureAssert.Equal(scene, picture);
    }
}
