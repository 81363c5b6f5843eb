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
    /// Adds to a digest the kind of shape and everything that <see cref="Intersect"/> depends on, so that parts of a picture that were drawn apart
    /// are joined only if they show the same; the colour is in it already.
    /// </summary>
    /// <exception cref="NotSupportedException">A class derived from this one does not override it.</exception>
    public virtual void AddTo(SceneDigest digest) => throw SceneDigest.Unknown(GetType());

    /// <summary>What kind of shape it is, as a scene file calls it.</summary>
    internal virtual string Kind => GetType().Name.ToLowerInvariant();

    /// <summary>How many shapes with a formula it is made of: one, the triangles of a mesh, none for a model in plain doubles and ifs.</summary>
    internal virtual int PartCount => 0;

    /// <summary>Where any kind of ray crosses one of its shapes, by the shape's own formula; null where it has none.</summary>
    /// <param name="ray">The ray; its direction has length 1.</param>
    /// <param name="part">Which of the <see cref="PartCount"/> shapes, from 0.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    internal virtual Crossings<N>? Cross<N>(in Ray<N> ray, int part) where N : struct, IReal<N> => null;

    /// <summary>What is known of the surface of one of its shapes, or of the model itself if it has none; null where nothing is.</summary>
    /// <inheritdoc cref="Cross{N}"/>
    internal virtual ISurface? SurfaceOf(int part) => this as ISurface;

    /// <summary>The model as the camera of one picture sees it; pixel by pixel where a model knows only single rays.</summary>
    internal virtual ModelView See(Camera camera, int threads) => new SingleRayView(this);

    /// <summary>Joins the crowd of a scene of many models, if there it is found faster than by itself.</summary>
    internal virtual bool Join(Crowd crowd, int index) => false;

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

    /// <summary>Adds the name of the shape's type and the bits of its numbers.</summary>
    public override void AddTo(SceneDigest digest) => digest.Add(typeof(P).Name).AddBits([Primitive]);

    /// <inheritdoc/>
    internal override string Kind => typeof(P).Name.ToLowerInvariant();

    /// <inheritdoc/>
    internal override int PartCount => 1;

    /// <inheritdoc/>
    internal override Crossings<N>? Cross<N>(in Ray<N> ray, int part) => Primitive.Cross(ray);

    /// <inheritdoc/>
    internal override ISurface? SurfaceOf(int part) => Primitive as ISurface;

    /// <inheritdoc/>
    internal override ModelView See(Camera camera, int threads) => new PrimitiveView<P>(Primitive, camera);

    /// <inheritdoc/>
    internal override bool Join(Crowd crowd, int index) => crowd.Add(Primitive, index);
}
