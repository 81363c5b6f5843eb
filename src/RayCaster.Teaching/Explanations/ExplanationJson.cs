namespace RayCaster.Teaching;

/// <summary>
/// An explanation for programs: JSON in which each number reads back as the same double. docs/explain.md lists the fields.
/// </summary>
public static class ExplanationJson
{
    /// <summary>The text, with the same pixel in another picture if there is one.</summary>
    public static string Of(PixelExplanation pixel, ReferenceExplanation? reference = null) => JsonText.Of(new
    {
        Pixel = new { pixel.Column, pixel.Line, pixel.Row, pixel.Scene.Camera.Width, pixel.Scene.Camera.Height },
        Camera = Camera(pixel.Scene.Camera, pixel.CameraSteps),
        Ray = new
        {
            pixel.Ray.Origin,
            pixel.Ray.Direction,
            pixel.Ray.ZPerT,
            Slide = Slides.PixelTranslation,
            Steps = Steps(pixel.RaySteps),
        },
        Models = pixel.Models.Select(Model),
        pixel.Others,
        Hit = pixel.Winner is { } index ? Hit(pixel, index) : JsonText.Null,
        Color = Color(pixel),
        pixel.Notes,
        Reference = reference is null ? null : new
        {
            reference.Bytes,
            reference.Difference,
            reference.Agrees,
            reference.Causes,
        },
    });

    private static object Camera(Camera camera, IReadOnlyList<FormulaStep> steps) => new
    {
        camera.Position,
        camera.Target,
        camera.Up,
        camera.FovY,
        camera.ZNear,
        camera.ZFar,
        camera.Bias,
        camera.Clip,
        camera.Sample,
        camera.Reach,
        Slide = Slides.Camera,
        Steps = Steps(steps),
    };

    private static object Model(ModelExplanation model) => new
    {
        model.Index,
        model.Name,
        model.Type,
        Verdict = model.Outcome.Verdict(),
        model.Reason,
        Slide = ShapeKind.Of(model.Type)?.Slide,
        model.Beside,
        Mesh = model.Mesh is { } mesh ? Triangles(mesh) : null,
        Steps = Steps(model.Steps),
        Slabs = model.Slabs.Count > 0 ? model.Slabs : null,
        model.Weights,
        Crossings = model.Crossings.Select(crossing => new
        {
            crossing.T,
            crossing.Z,
            Verdict = crossing.Outcome.Verdict(),
            Refusal = crossing.Outcome.Refusal(),
            crossing.Reason,
            crossing.Untested,
            crossing.Numbers,
        }),
    };

    private static object Triangles(MeshExplanation mesh) => new
    {
        mesh.Triangles,
        Triangle = mesh.Triangle ?? JsonText.Null,
        mesh.Missed,
        mesh.Behind,
        mesh.UnderBias,
        mesh.BeforeNear,
        mesh.BeyondFar,
        mesh.Counting,
    };

    private static object Hit(PixelExplanation pixel, int index) => new
    {
        Model = index,
        Name = pixel.NameOf(index),
        T = pixel.Ray.HitParameter,
        Point = pixel.Ray.At(pixel.Ray.HitParameter),
        Hides = pixel.Trials.Where(trial => trial.Hit is not null && trial.Index != index)
            .Select(trial => new { Model = trial.Index, T = trial.Hit }),
    };

    private static object Color(PixelExplanation pixel) => new
    {
        Attenuation = pixel.AttenuationSteps is [.., { } attenuation] ? attenuation.Value : JsonText.Null,
        Full = pixel.Ray.HitModel?.Color ?? pixel.Scene.Background,
        Value = pixel.Color,
        pixel.Bytes,
        Slide = Slides.Shading,
        Steps = Steps([.. pixel.AttenuationSteps, .. pixel.ColorSteps]),
    };

    private static IEnumerable<object> Steps(IReadOnlyList<FormulaStep> steps) => steps.Select(step => new
    {
        step.Name,
        step.Formula,
        step.Numbers,
        Value = step.IsTest ? step.Value != 0 : step.Values is [var only] ? only : (object)step.Values,
    });
}
