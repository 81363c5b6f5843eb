namespace RayCaster.Teaching.Formulas;

/// <summary>What a section's formulas are for, in pipeline order.</summary>
internal enum StepKind
{
    Vectors,
    Camera,
    File,
    Sample,
    Pixel,
    Plane,
    Circle,
    Sphere,
    Aabb,
    Triangle,
    Rule,
    Nearest,
    Light,
    Bytes,
}

internal static class StepKinds
{
    /// <summary>Whether a step is on the way from a pixel to its ray.</summary>
    public static bool IsOfRays(this StepKind step) =>
        step is StepKind.Vectors or StepKind.Camera or StepKind.Sample or StepKind.Pixel;

    /// <summary>Whether a step is the formula of a kind of shape.</summary>
    public static bool IsOfShape(this StepKind step) => step is >= StepKind.Plane and <= StepKind.Triangle;

    /// <summary>Whether a step decides which crossing counts, and which of two hits shows.</summary>
    public static bool IsOfHits(this StepKind step) => step is StepKind.Rule or StepKind.Nearest;

    /// <summary>Whether a step is on the way from a hit to three bytes.</summary>
    public static bool IsOfColors(this StepKind step) => step is StepKind.Light or StepKind.Bytes;
}
