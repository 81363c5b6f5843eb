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
            pixel.Ray.DepthPerT,
            Slide = Slides.PixelTranslation,
            Steps = pixel.RaySteps,
        },
        Models = pixel.Models.Select(Model),
        Others = Others(pixel.Others),
        Hit = pixel.Winner is { } index ? Hit(pixel, index) : JsonText.Null,
        Color = Color(pixel),
        pixel.Notes,
        Reference = reference,
    });

    private static object Camera(Camera camera, object steps) => new
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
        camera.FadeDistance,
        Slide = Slides.Camera,
        Steps = steps,
    };

    private static object Model(ModelExplanation model) => new
    {
        model.Fate.Index,
        model.Name,
        Type = model.Fate.Model.Kind,
        Verdict = model.Fate.Outcome.Verdict(),
        model.Reason,
        Slide = Slides.OfShape(model.Fate.Model.Kind),
        model.Beside,
        Mesh = model.Fate is { Triangles: { } triangles, Triangle: var triangle } ? Mesh(triangles, triangle) : null,
        model.Steps,
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

    private static object Mesh(Tally triangles, int? triangle) => new
    {
        Triangles = triangles.Total,
        Triangle = triangle ?? JsonText.Null,
        Missed = triangles[Outcome.Misses],
        Behind = triangles[Outcome.Behind],
        UnderBias = triangles[Outcome.UnderBias],
        BeforeNear = triangles[Outcome.BeforeNear],
        BeyondFar = triangles[Outcome.BeyondFar],
        Counting = triangles[Outcome.Shows],
    };

    private static object Others(Tally others) => new
    {
        Count = others.Total,
        Hidden = others[Outcome.Hidden],
        Behind = others[Outcome.Behind],
        UnderBias = others[Outcome.UnderBias],
        BeforeNear = others[Outcome.BeforeNear],
        BeyondFar = others[Outcome.BeyondFar],
        Missed = others[Outcome.Misses],
    };

    private static object Hit(PixelExplanation pixel, int index) => new
    {
        Model = index,
        Name = pixel.NameOf(index),
        T = pixel.Ray.HitParameter,
        Point = pixel.Ray.At(pixel.Ray.HitParameter),
        Hides = pixel.Fates.Where(fate => fate.Outcome == Outcome.Hidden).Select(fate => new { Model = fate.Index, fate.T }),
    };

    private static object Color(PixelExplanation pixel) => new
    {
        Attenuation = pixel.ColorSteps.FirstOrDefault(step => step.Name == "attenuation")?.Value ?? JsonText.Null,
        Full = pixel.Ray.HitModel?.Color ?? pixel.Scene.Background,
        Value = pixel.Color,
        pixel.Bytes,
        Slide = Slides.Shading,
        Steps = pixel.ColorSteps,
    };
}
