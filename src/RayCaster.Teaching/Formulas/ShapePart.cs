namespace RayCaster.Teaching.Formulas;

/// <summary>What the formulas of a step cross: a model, or a triangle of a small mesh.</summary>
/// <param name="Kind">The step with its formula; null for what the definition draws: a shape of one's own, and a mesh of no triangle or of many.
/// </param>
/// <param name="Numbers">The numbers that the step is given.</param>
internal sealed record ShapePart(Model Model, StepKind? Kind, (Symbol Name, PixelValues Value)[] Numbers)
{
    /// <summary>A mesh with more triangles is drawn by the definition.</summary>
    public const int MaxTriangles = 100;

    /// <summary>The parts of a model: one, but for a small mesh.</summary>
    public static IEnumerable<ShapePart> From(Model model) => model switch
    {
        Mesh { TriangleCount: > 0 and <= MaxTriangles } mesh =>
            Enumerable.Range(0, mesh.TriangleCount).Select(i => new ShapePart(mesh, StepKind.Triangle, NumbersOf(mesh[i]))),
        _ when ShapeKind.Find(model.Kind) is { } kind && kind.NumbersOf(model) is { } numbers => [new(model, kind.Step, Named(kind.Step, numbers))],
        _ => [new(model, null, [])],
    };

    public static (Symbol Name, PixelValues Value)[] NumbersOf(Triangle triangle) =>
        Named(StepKind.Triangle, [PixelValues.From(triangle.A), PixelValues.From(triangle.B), PixelValues.From(triangle.C)]);

    /// <summary>Values with the names that a step is given.</summary>
    public static (Symbol Name, PixelValues Value)[] Named(StepKind step, PixelValues[] values) =>
        [.. FormulaBook.Slides.GivenTo(step).Zip(values)];
}
