namespace RayCaster;

/// <summary>
/// Something visible: a shape with a colour. Derive from it to write a shape in plain doubles and ifs (docs/adding-a-primitive.md);
/// a shape written as an <see cref="IPrimitive"/> becomes one by <see cref="Of{P}"/> and is drawn several pixels at once.
/// </summary>
public abstract class Model
{
    /// <summary>A name for people; null where the scene gives none.</summary>
    public string? Name { get; set; }

    /// <summary>Its colour in full light; white where the scene gives none.</summary>
    public Color Color { get; set; } = Color.White;

    /// <summary>The parameter t of the first crossing with the ray that counts (<see cref="Ray.Counts"/>), or null.</summary>
    public abstract double? Intersect(Ray ray);

    /// <summary>
    /// All numbers that <see cref="Intersect"/> depends on, so that parts of a picture that were drawn apart are joined only if they show the same.
    /// Null for a class that does not say; a picture with such a model cannot be drawn in parts.
    /// </summary>
    public virtual IReadOnlyList<double>? Numbers => null;

    /// <summary>What kind of shape it is, as a scene file calls it.</summary>
    public virtual string Kind => GetType().Name.ToLowerInvariant();

    /// <summary>What is known of its surface; null for a model that does not say, and for a mesh, whose triangles do.</summary>
    public virtual ISurface? Surface => this as ISurface;

    /// <summary>A box around it; null for a shape that is endless or does not say.</summary>
    public virtual Bounds? Bounds => (this as IBounded)?.Bounds;

    /// <summary>Where any kind of ray crosses the shape, by its own formula; null where there is none to run: for a mesh, and for plain doubles
    /// and ifs.</summary>
    /// <param name="ray">The ray; its direction has length 1.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    public virtual Crossings<N>? Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => null;

    /// <summary>Calls the visitor's method for this kind of model.</summary>
    public virtual void Accept(IModelVisitor visitor) => visitor.VisitOther(this);

    /// <summary>Makes a model of a shape.</summary>
    public static Model<P> Of<P>(P primitive) where P : struct, IPrimitive => new(primitive);
}

/// <summary>A model whose shape states its crossing as a formula.</summary>
/// <typeparam name="P">The kind of shape.</typeparam>
/// <param name="primitive">The shape.</param>
public sealed class Model<P>(P primitive) : Model where P : struct, IPrimitive
{
    /// <summary>The shape.</summary>
    public P Primitive { get; } = primitive;

    /// <inheritdoc/>
    public override double? Intersect(Ray ray)
    {
        var crossings = Primitive.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction));
        double t = ray.Clip.First<Scalar>(crossings, ray.ZPerT);
        return double.IsNaN(t) ? null : t;
    }

    /// <inheritdoc/>
    public override string Kind => typeof(P).Name.ToLowerInvariant();

    /// <inheritdoc/>
    public override ISurface? Surface => Primitive as ISurface;

    /// <inheritdoc/>
    public override Bounds? Bounds => (Primitive as IBounded)?.Bounds;

    /// <inheritdoc/>
    public override Crossings<N>? Intersect<N>(in Ray<N> ray) => Primitive.Intersect(ray);

    /// <inheritdoc/>
    public override void Accept(IModelVisitor visitor) => visitor.Visit(this);
}
