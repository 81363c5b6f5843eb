namespace RayCaster;

/// <summary>
/// A shape whose intersection with a ray is one formula over any kind of number. To add a shape, write a file like Sphere.cs and a line in
/// PrimitiveList.cs (docs/adding-a-primitive.md).
/// </summary>
public interface IPrimitive
{
    /// <summary>
    /// Where the ray X(t) = P + t d crosses the shape, also behind its origin: <see cref="ClipRange"/> decides which crossings count.
    /// </summary>
    /// <param name="ray">The ray; its direction has length 1.</param>
    /// <returns>The parameters t, in units of length, nearest first; NaN for none.</returns>
    Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>;
}
