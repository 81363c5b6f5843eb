namespace RayCaster.Teaching;

/// <summary>The titles of the slides, as the slides have them; docs/slides-to-code.md lists them all.</summary>
internal static class Slides
{
    public const string Vectors = "IDE & Vectors";
    public const string RayCasting = "Ray Casting";
    public const string Template = "Template";
    public const string RayPlane = "Ray – Plane Intersection";
    public const string Camera = "Camera";
    public const string PixelTranslation = "Camera Pixel Translation";
    public const string Shading = "Primitive Shading";
    public const string ClipPlanes = "zNear & zFar";
    public const string Bias = "Bias";
    public const string Box = "AABB (Axis Aligned Bounding Box)";
    public const string BoxParameters = "AABB – intersection parameters";
    public const string BoxTest = "AABB checking for intersection";
    public const string Sphere = "Sphere – Geometric Solution";
    public const string SphereAnalytical = "Sphere – Analytical Solution";
    public const string Circle = "Circle";
    public const string Triangle = "Triangle";
}
