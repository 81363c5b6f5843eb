namespace RayCaster;

/// <summary>
/// A visible object: a shape with a colour. <see cref="Of{P}"/> makes one of an <see cref="IPrimitive"/>, whose formula the engine runs for
/// several pixels at once.
/// A scalar shape is a class that derives from Model and computes with one ray's doubles and ifs (docs/adding-a-primitive.md).
/// </summary>
public abstract class Model
{
    /// <summary>A name for people; null if the scene gives none.</summary>
    public string? Name { get; set; }

    /// <summary>Its colour without attenuation.</summary>
    public Color Color { get; set; } = Color.White;

    /// <summary>The parameter t of the first crossing with the ray that counts (<see cref="Ray.Counts"/>), or null.</summary>
    public abstract double? Intersect(Ray ray);

    /// <summary>The kind of shape, as a scene file names it.</summary>
    public virtual string Kind => GetType().Name.ToLowerInvariant();

    /// <summary>A box around it; null if the shape does not implement <see cref="IBounded"/>.</summary>
    public virtual Bounds? Bounds => (this as IBounded)?.Bounds;

    /// <summary>Calls the visitor with the shape, and returns what that returns; false for models without a formula: meshes and scalar
    /// shapes.</summary>
    public virtual bool Accept(IShapeVisitor visitor) => false;

    /// <summary>Makes a model of a primitive.</summary>
    public static Model<P> Of<P>(P primitive) where P : struct, IPrimitive => new(primitive);
}

/// <summary>A model with a primitive, whose formula runs over any kind of number.</summary>
public sealed class Model<P>(P primitive) : Model where P : struct, IPrimitive
{
    /// <summary>The shape.</summary>
    public P Primitive { get; } = primitive;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public override double? Intersect(Ray ray)
    {
        var crossings = Primitive.Intersect(new Ray<Scalar>(ray.Origin, ray.Direction));
        if (ray.Counts(crossings.Near)) return crossings.Near;
        return ray.Counts(crossings.Far) ? crossings.Far : null; // where the near side of a solid is clipped away, its far side shows
    }

    /// <inheritdoc/>
    public override string Kind => typeof(P).Name.ToLowerInvariant();

    /// <summary>The shape and its numbers.</summary>
    public override string ToString() => $"{Primitive}";

    /// <inheritdoc/>
    public override Bounds? Bounds => (Primitive as IBounded)?.Bounds;

    /// <inheritdoc/>
    public override bool Accept(IShapeVisitor visitor) => visitor.Visit(Primitive);
}
