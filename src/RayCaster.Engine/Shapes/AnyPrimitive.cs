namespace RayCaster.Engine;

/// <summary>A model of a primitive that the engine does not know: its formula runs through a virtual call for each packet.</summary>
internal readonly struct AnyPrimitive(Model model) : IPrimitive
{
    /// <summary>Whether a model's formula runs over any kind of number; a scalar shape's does not.</summary>
    public static bool HasFormula(Model model) => model.Intersect(new Ray<Scalar>(Vector3.Zero, new Vector3(0, 0, 1))) is not null;

    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => model.Intersect(ray)!.Value;
}
