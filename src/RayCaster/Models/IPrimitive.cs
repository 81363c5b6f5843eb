namespace RayCaster;

/// <summary>
/// A shape that states its crossing with a ray once, as a formula over any kind of number.
/// To add one see docs/adding-a-primitive.md: a new file like Sphere.cs and a line in PrimitiveList.cs.
/// </summary>
public interface IPrimitive
{
    /// <summary>
    /// Where the ray X(t) = P + t d crosses the shape, behind the origin too; which crossings count is not the shape's business.
    /// </summary>
    /// <param name="ray">The ray; its direction has length 1.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    /// <returns>The parameters t, in units of length, nearest first; NaN for none.</returns>
    Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>;
}
