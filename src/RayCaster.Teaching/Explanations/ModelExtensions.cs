namespace RayCaster.Teaching.Explanations;

/// <summary>A model's formula over the numbers of an explanation.</summary>
internal static class ModelExtensions
{
    extension(Model model)
    {
        /// <summary>The crossings by the shape's formula; null for models that have none: meshes and scalar shapes.</summary>
        public Crossings<N>? Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
        {
            var formula = new Formula<N>(ray);
            return model.Accept(formula) ? formula.Crossings : null;
        }
    }

    private sealed class Formula<N>(Ray<N> ray) : IShapeVisitor where N : struct, IReal<N>
    {
        public Crossings<N> Crossings { get; private set; }

        public bool Visit<P>(P shape) where P : struct, IPrimitive
        {
            Crossings = shape.Intersect(ray);
            return true;
        }
    }
}
