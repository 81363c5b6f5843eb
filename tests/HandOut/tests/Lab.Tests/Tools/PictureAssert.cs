using System.Diagnostics;
using RayCaster;
using RayCaster.Files;
using RayCaster.Teaching;

namespace Lab.Tests;

/// <summary>Compares the lab's pictures with references, whichever program has drawn these.</summary>
[StackTraceHidden] // the trace of a failure begins in the test
public static class PictureAssert
{
    /// <summary>The lab's picture of a scene is the reference, except for pixels on outlines, where the last bits decide.</summary>
    /// <param name="sceneFile">The scene.</param>
    /// <param name="reference">A PNG or PPM; the scene is drawn in its size.</param>
    public static void Equal(string sceneFile, string reference)
    {
        var (scene, picture) = (Read(sceneFile), PictureFile.Read(reference));
        scene = scene.WithSize(picture.Width, picture.Height);
        Equal(Path.GetFileNameWithoutExtension(sceneFile), scene, [picture], 0);
    }

    /// <summary>The lab's picture of what a scene shows after a step is the reference of that step.</summary>
    public static void EqualAt(int step, params string[] names)
    {
        if (Todo.Missing(step).Length > 0) Assert.Fail(Todo.Report(step));
        foreach (var name in names)
        {
            var scene = Read(Path.Combine(LabFolder.Scenes, name + ".json"));
            var references = new List<Picture> { Reference(scene, name, step) };
            if (step == LabSteps.FirstPicture) references.Add(Reference(scene, name, step + 1)); // for a student who has written the shading, too
            var at = LabSteps.SceneAt(scene, step);
            if (!new PictureJudge(references[0]).Judge(LabSteps.Draw(scene, step)).IsSame()) // the library draws what the student's file now says
                Assert.Fail($"scenes/{name}.json is not as it was handed out. Copy it to scenes/my to play with it, " +
                    $"and restore this one: git restore scenes/{name}.json");
            Equal($"{name.Replace('/', '-')}-step{step}", at, references, step);
        }
    }

    private static void Equal(string name, RayCaster.Scene scene, List<Picture> references, int step)
    {
        var mine = SceneFile.Of(scene).Draw();
        var own = step == LabSteps.FirstPicture ? null : scene; // without attenuation it is not the scene's picture
        var received = Path.Combine(LabFolder.Root, "received", name + ".png");
        var expected = Path.ChangeExtension(received, ".expected.png");
        foreach (var ofTheLastRun in (string[])[received, expected])
            if (File.Exists(ofTheLastRun)) File.Delete(ofTheLastRun);
        if (references.Exists(reference => new PictureJudge(reference, own).Judge(mine).IsSame())) return;

        var nearest = references.MinBy(reference => new PictureDifference(mine, reference).CountBeyond(0));
        Directory.CreateDirectory(Path.GetDirectoryName(received));
        PictureFile.Write(received, mine);
        PictureFile.Write(expected, nearest);
        var hint = StepHint.Of(scene, mine, step, Teacher.Hints, new Proof(scene).IsRight);
        Assert.Fail($"{Difference(mine, nearest)}\n  yours:    {received}\n  expected: {expected}\n{hint}");
    }

    private static string Difference(Picture mine, Picture reference)
    {
        var difference = new PictureDifference(mine, reference);
        var where = difference.WrongMiddle is var (x, y)
            ? $"in the widest wrong area at column {x}, line {y} from the top: expected {reference[x, y]}, but got {mine[x, y]}"
            : "by one level: round, do not cut";
        return $"{difference.CountBeyond(0):N0} of {difference.Pixels:N0} pixels differ, {where}";
    }

    private static Picture Reference(RayCaster.Scene scene, string name, int step)
    {
        var file = LabFolder.Reference(name, step);
        return File.Exists(file) ? PictureFile.Read(file) : LabSteps.Draw(scene, step); // this project's own repository keeps none
    }

    private static RayCaster.Scene Read(string file)
    {
        var reading = SceneReader.Read(file);
        return reading.Scene ?? throw new InvalidDataException(reading.Report());
    }
}
