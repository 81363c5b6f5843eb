using System.Diagnostics;
using RayCaster;
using RayCaster.Files;
using RayCaster.Teaching.Comparison;
using RayCaster.Teaching.Course;
using RayCaster.Teaching.Diagnosis;

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
        var resized = scene.WithSize(picture.Width, picture.Height);
        Equal(Path.GetFileNameWithoutExtension(sceneFile), resized == scene ? sceneFile : null, resized, SceneFile.Of(resized).Draw(), [picture], 0);
    }

    /// <summary>The lab's picture of what a scene shows after a step is the reference of that step.</summary>
    public static void EqualAt(int step, params string[] names)
    {
        if (Todo.Missing(step).Length > 0) Assert.Fail(Todo.Report(step));
        var drawn = (
            from name in names
            let file = Path.Combine(LabFolder.Scenes, name + ".json")
            let whole = Read(file)
            // This project's own repository keeps no pictures: there the library draws them, too, and a third of the size is enough.
            let keepsOne = File.Exists(LabFolder.Reference(name, step))
            let scene = keepsOne ? whole : whole.WithSize(whole.Camera.Width / 3, whole.Camera.Height / 3)
            select (name, keepsOne ? file : null, scene, Task.Run(SceneFile.Of(LabSteps.SceneAt(scene, step)).Draw))).ToList(); // all at once
        foreach (var (name, sceneFile, scene, mine) in drawn)
        {
            var references = new List<Picture> { Reference(scene, name, step) };
            if (step == LabSteps.FirstPicture) references.Add(Reference(scene, name, step + 1)); // for a student who has written the shading, too
            var at = LabSteps.SceneAt(scene, step);
            Equal($"{name.Replace('/', '-')}-step{step}", sceneFile, at, mine.GetAwaiter().GetResult(), references, step);
        }
    }

    /// <param name="sceneFile">Null if it has another size.</param>
    private static void Equal(string name, string sceneFile, RayCaster.Scene scene, Picture mine, List<Picture> references, int step)
    {
        var own = step == LabSteps.FirstPicture ? null : scene; // without attenuation it is not the scene's picture
        var received = Path.Combine(LabFolder.Root, "received", name + ".png");
        var expected = Path.ChangeExtension(received, ".expected.png");
        foreach (var ofTheLastRun in (string[])[received, expected])
            if (File.Exists(ofTheLastRun)) File.Delete(ofTheLastRun);
        // By the pictures alone: a scene that the student has changed would explain the difference. Most are right, and cost no more.
        if (references.Exists(reference => new PictureJudge(reference).Compare(mine) is Likeness.Identical or Likeness.WithinRounding)) return;
        if (step > 0 && !new PictureJudge(references[0]).Compare(LabSteps.Draw(scene, step)).IsSame()) // the library draws what the file now says
        {
            var file = Path.GetRelativePath(LabFolder.Root, sceneFile).Replace('\\', '/');
            Assert.Fail($"{file} is not as it was handed out. Copy it to scenes/my to play with it, and restore this one: git restore {file}");
        }
        if (references.Exists(reference => new PictureJudge(reference, own).Compare(mine).IsSame())) return; // but for outlines

        var nearest = references.MinBy(reference => new PictureDifference(mine, reference).CountBeyond(0));
        Directory.CreateDirectory(Path.GetDirectoryName(received));
        PictureFile.Write(received, mine);
        PictureFile.Write(expected, nearest);
        // What wrong formulas draw tells less than their own tests, unless one mistake explains all of it.
        var hint = FormulaTests.FirstFailure(step > 0 ? step : LabSteps.Count) is { } failure
            ? $"  First let the formulas' tests pass: {failure}{StepHint.OfAllPixels(scene, mine, int.Parse(failure[4..6]), Teacher.Hints)}"
            : StepHint.Format(scene, mine, step, Teacher.Hints);
        var difference = new PictureDifference(mine, nearest);
        Assert.Fail($"{Text(difference, nearest)}\n  yours:    {received}\n  expected: {expected}\n{hint}{OwnNumbers(sceneFile, difference)}");
    }

    private static string Text(PictureDifference difference, Picture reference)
    {
        var where = difference.WrongMiddle is var (x, y)
            ? $"in the widest wrong area at column {x}, line {y} from the top: expected {reference[x, y]}, but got {difference.Mine[x, y]}"
            : "by one level of 255. Which byte does your program make of 127.9?";
        return $"{difference.CountBeyond(0):N0} of {difference.Pixels:N0} pixels differ, {where}";
    }

    /// <summary>The command that shows what the bodies compute in the middle of the widest wrong area.</summary>
    private static string OwnNumbers(string sceneFile, PictureDifference difference)
    {
        if (sceneFile == null || difference.WrongMiddle is not var (x, y)) return "";
        var file = Path.GetRelativePath(LabFolder.Root, sceneFile).Replace('\\', '/');
        var hint = Teacher.Hints == HintLevel.Answer ? "" : $" --hint {Teacher.Hints.ToString().ToLowerInvariant()}";
        return $"\n  Your numbers there: dotnet run --project src/Lab -- {file} --pixel {x} {y}{hint}";
    }

    private static Picture Reference(RayCaster.Scene scene, string name, int step)
    {
        var file = LabFolder.Reference(name, step);
        return File.Exists(file) ? PictureFile.Read(file) : LabSteps.Draw(scene, step);
    }

    private static RayCaster.Scene Read(string file)
    {
        var reading = SceneReader.Read(file);
        return reading.Scene ?? throw new InvalidDataException(reading.Report());
    }
}
