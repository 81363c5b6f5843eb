namespace RayCaster.Testing;

/// <summary>One ray and one shape.</summary>
internal static class Cast
{
    /// <summary>Both crossings of a shape with the line through the origin, NaN where there is none.</summary>
    public static (double Near, double Far) Line<P>(P shape, Vector3 origin, Vector3 direction) where P : IPrimitive
    {
        var crossings = shape.Intersect(new Ray<Scalar>(origin, direction.Normalized));
        return (crossings.Near, crossings.Far);
    }

    /// <summary>The hit of a ray that counts everything in front of its origin.</summary>
    public static double? At<P>(P shape, Vector3 origin, Vector3 direction) where P : struct, IPrimitive =>
        Model.Of(shape).Intersect(new Ray(origin, direction.Normalized));
}
