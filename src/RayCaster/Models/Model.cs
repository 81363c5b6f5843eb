using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>
/// Something visible: a shape with a colour. Derive from it to write a shape in plain doubles and ifs (docs/adding-a-primitive.md);
/// a shape written as an <see cref="IPrimitive"/> becomes one by <see cref="Of{P}"/> and is drawn several pixels at once.
/// </summary>
public abstract class Model
{
    /// <summary>What messages call it; null where the scene gives no name.</summary>
    public string? Name { get; set; }

    /// <summary>Its colour in full light; white where the scene gives none.</summary>
    public Color Color { get; set; } = Color.White;

    /// <summary>The parameter t of the first crossing with the ray that counts (<see cref="Ray.Counts"/>), or null.</summary>
    public abstract double? Intersect(Ray ray);

    /// <summary>The same for a span of pixels at once; lane by lane where a model knows only single rays.</summary>
    /// <param name="span">The rays; keeps the hits that are nearer than all before.</param>
    /// <param name="index">The model's place in the scene.</param>
    internal virtual void Meet(RaySpan span, int index) => span.MeetLaneByLane(this, index);

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
        var crossings = Primitive.Cross(new Ray<Scalar>(ray.Origin, ray.Direction));
        double t = ray.Clip.First<Scalar>(crossings, ray.ZPerT);
        return double.IsNaN(t) ? null : t;
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // a picture is often drawn before the runtime would optimise by itself
    internal override void Meet(RaySpan span, int index)
    {
        var primitive = Primitive; // a local, so that its constants stay in registers
        for (var i = 0; i < span.PacketCount; i++)
            span.Keep(i, span.First(i, primitive.Cross(span.RaysOf(i))), index);
    }
}
