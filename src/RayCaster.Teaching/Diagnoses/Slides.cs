namespace RayCaster.Teaching;

/// <summary>The titles of the slides, as docs/slides-to-code.md has them.</summary>
internal static class Slides
{
    public const string Vectors = "Vectors";
    public const string CrossProduct = "Cross product";
    public const string Camera = "Camera";
    public const string RayThroughPixel = "Ray through a pixel";
    public const string ClipPlanes = "Near and far plane";
    public const string NearestHit = "Nearest hit";
    public const string Plane = "Plane";
    public const string Circle = "Circle";
    public const string Sphere = "Sphere – Geometric Solution";
    public const string Box = "Axis-aligned bounding box";
    public const string Triangle = "Triangle – Barycentric Coordinates";
    public const string Attenuation = "Attenuation";
    public const string Picture = "Picture";
}
