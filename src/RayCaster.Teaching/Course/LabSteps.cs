namespace RayCaster.Teaching.Course;

/// <summary>The ten steps in which students write the lab, and the picture after each, which is the hand-out's reference.</summary>
public static class LabSteps
{
    /// <summary>How many steps there are.</summary>
    public static int Count => Slides.Steps.Count;

    /// <summary>The first step with rays; before it, the lab draws a gradient.</summary>
    public const int FirstPicture = 4;

    /// <summary>The last of the steps that decide which hits show and in which light.</summary>
    internal const int Clipping = 6;

    private const int Shading = 5;

    /// <summary>Whether a mistake is one of the code of a step: of its slide or of the shape that is written in it.</summary>
    public static bool IsOf(Change mistake, int step) => Slides.StepOf(mistake.Slide) == step
        || ShapeKind.All.Any(kind => mistake.Steps.Contains(kind.Step) && Slides.StepOf(kind.Slide) == step);

    /// <summary>
    /// The part of a scene that the lab can draw after a step: the models whose formulas are written. Before the step of zNear, zFar and bias,
    /// every hit in front of the camera counts.
    /// </summary>
    public static Scene SceneAt(Scene scene, int step)
    {
        var c = scene.Camera;
        return scene with
        {
            Models = [.. scene.Models.Where(model => StepOf(model) <= step)],
            // The least bias that exists: t > 0.
            Camera = step >= Clipping
                ? c
                : c with { ZNear = 0, ZFar = double.MaxValue, Bias = double.Epsilon },
        };
    }

    /// <summary>The picture after a step.</summary>
    public static Picture Draw(Scene scene, int step)
    {
        if (step < FirstPicture) return Gradient(scene.Camera.Width, scene.Camera.Height);
        scene = SceneAt(scene, step);
        return step < Shading ? Unshaded(scene) : Renderer.Render(scene);
    }

    /// <summary>Whether the picture after a step is another than before it: with the first rays, with light, with clipping, or with a shape of the
    /// scene.</summary>
    public static bool Changes(Scene scene, int step) =>
        step is 1 or FirstPicture or Shading or Clipping || (step > FirstPicture && KindsOf(scene, step).Any());

    /// <summary>What of a scene surely works when a step is written, as a diagnosis calls it; the step's own shape may be missing in a
    /// picture.</summary>
    internal static string[] DoneAt(Scene scene, int step) =>
    [
        .. scene.Models.Where(model => StepOf(model) < step).Select(model => model.Kind).Distinct(),
        .. step >= Shading ? (string[])[MissingPart.Attenuation] : [],
        .. step >= Clipping ? (string[])[MissingPart.Clipping] : [],
    ];

    /// <summary>The kinds of shape in a scene whose formula is written in a step.</summary>
    internal static IEnumerable<string> KindsOf(Scene scene, int step) =>
        scene.Models.Where(model => StepOf(model) == step).Select(model => model.Kind).Distinct();

    private static int StepOf(Model model) => ShapeKind.Find(model.Kind)?.Slide is { } slide ? Slides.StepOf(slide) : Count;

    /// <summary>Each model in its full colour, without attenuation.</summary>
    private static Picture Unshaded(Scene scene)
    {
        var hits = new Renderer(scene).CastHits();
        return Picture.Create(hits.Width, hits.Height, (x, y) =>
            (hits.Model[y * hits.Width + x] is >= 0 and var model ? scene.Models[model].Color : scene.Background).ToBytes());
    }

    private static Picture Gradient(int width, int height) => Picture.Create(width, height, (x, y) =>
        new Color((double)x / width, (double)(height - 1 - y) / height, 0.5).ToBytes());
}
