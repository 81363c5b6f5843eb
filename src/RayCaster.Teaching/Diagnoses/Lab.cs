using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>
/// The definition of a picture as replaceable steps, in pipeline order. Each step is the definition's own until a
/// <see cref="Mistake"/> changes it; without a mistake every byte is that of <see cref="ScalarRenderer"/>. Several threads may draw
/// with a lab, unless one of them sets <see cref="IsUnaffected"/>.
/// </summary>
internal sealed partial class Lab
{
    /// <summary>Sets up the program of a student who has made these mistakes, in this order; none for the definition.</summary>
    public Lab(Scene scene, params ReadOnlySpan<Mistake> mistakes)
    {
        Scene = scene;
        models = [.. scene.Models];
        (P, T) = (Camera.Position, Camera.Target);
        (Width, Height) = (Camera.Width, Camera.Height);
        clip = Camera.ClipRange;
        half = Camera.Sample == PixelSample.Center ? 0.5 : 0;

        foreach (var mistake in mistakes)
        {
            mistake.Deviate(this);
            if (mistake.Id != "center") made++;
        }
        SetUp();
    }

    /// <summary>Computes what is the same for all rays.</summary>
    private void SetUp()
    {
        W = AxisW.Do(ToTarget.Do(P, T));
        U = AxisU.Do(Camera.Up, W);
        V = AxisV.Do(W, U);
        h = PlaneHeight.Do(Camera.FovY);
        w = PlaneWidth.Do(h);
        reach = FadeDistance.Do();
    }

    /// <summary>The shapes whose own formulas its mistakes change.</summary>
    public Affects ChangedShapes =>
        (Plane.IsChanged ? Affects.Planes : 0) | (Sphere.IsChanged ? Affects.Spheres : 0) | (Box.IsChanged ? Affects.Boxes : 0)
        | (Circle.IsChanged ? Affects.Circles : 0) | (Triangle.IsChanged ? Affects.Triangles : 0);

    /// <summary>As many models as a ray may try; with more a scene's mistakes are not tried at all.</summary>
    public const int MaxModels = 10_000;

    /// <summary>As many triangles as a ray may try one by one; with more a mistake is not tried at all.</summary>
    public const int MaxTriangles = 20_000;

    /// <summary>The same beside another mistake: there are thousands of pairs.</summary>
    private const int MaxTrianglesBeside = 1000;

    private readonly Model[] models;
    private readonly ClipRange clip;
    private readonly double half;
    private double h, w, reach;
    private readonly int made; // mistakes; that rays pass through the other sample point of each pixel is a formula style, too

    /// <summary>What is drawn.</summary>
    public Scene Scene { get; }

    /// <summary>Its camera, whose numbers the steps take; its axes and its plane are computed here once more.</summary>
    public Camera Camera => Scene.Camera;

    /// <summary>P.</summary>
    public Vector3 P { get; private set; }

    /// <summary>T.</summary>
    public Vector3 T { get; private set; }

    /// <summary>To the right.</summary>
    public Vector3 U { get; private set; }

    /// <summary>Upwards.</summary>
    public Vector3 V { get; private set; }

    /// <summary>Backwards.</summary>
    public Vector3 W { get; private set; }

    /// <summary>width / height of the picture.</summary>
    public double Wide => (double)Camera.Width / Camera.Height;

    /// <summary>height / width of the picture.</summary>
    public double Tall => (double)Camera.Height / Camera.Width;

    /// <summary>Pixels in a line of the file.</summary>
    public int Width { get; private set; }

    /// <summary>Lines of the file.</summary>
    public int Height { get; private set; }

    /// <summary>Whether triangles are hit outside of themselves, so that nothing can be said about a mesh by its bounds.</summary>
    public bool TrianglesReachOut { get; set; }

    /// <summary>Whether the last bits decide for each pixel if the mistake shows there. Some pixels are unaffected.</summary>
    public bool Scatters { get; set; }

    /// <summary>Whether the pixel that is drawn now is one where a mistake that scatters does not show.</summary>
    public bool IsUnaffected { get; set; }

    /// <summary>Whether both crossings of a sphere or a box are offered one after the other, as Ray.Hit of the hand-out has it, not only
    /// the first that counts.</summary>
    public bool OffersBoth { get; set; }

    /// <summary>Swaps P and T.</summary>
    public void SwapEnds() => (P, T) = (T, P);

    /// <summary>Swaps the file's width and height.</summary>
    public void SwapSides() => (Width, Height) = (Height, Width);

    // ---- The way through the steps ----

    /// <summary>The pixel at column x, line y (0 = top) of the file.</summary>
    public (byte R, byte G, byte B) this[int x, int y] => Read.Do(x, y);

    /// <summary>The same by its place in reading order.</summary>
    public (byte R, byte G, byte B) this[int place] => this[place % Width, place / Width];

    /// <summary>The whole file.</summary>
    public Picture Render(int? threads = null)
    {
        var picture = new Picture(Width, Height);
        Parallel.For(0, Height, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, y =>
        {
            for (var x = 0; x < Width; x++) picture[x, y] = this[x, y];
        });
        return picture;
    }

    /// <summary>Whether a crossing counts.</summary>
    public bool Counts(double t, Vector3 d) => Ahead.Do(t) && Clipped.Do(t, Depth.Do(t, d));

    /// <summary>How many triangles of meshes each ray must try, one by one.</summary>
    public long TrianglesTried => TrianglesReachOut ? models.OfType<Mesh>().Sum(mesh => (long)mesh.TriangleCount) : 0;

    /// <summary>How many of some rays are cast within so many tries.</summary>
    public int RaysWithin(double tries, int rays) => TrianglesTried == 0 ? rays : (int)Math.Min(rays, tries / TrianglesTried);

    /// <summary>Whether that takes too long for a search.</summary>
    public bool TakesTooLong => TrianglesTried > (made > 1 ? MaxTrianglesBeside : MaxTriangles);

    /// <summary>The ray from the camera in a direction.</summary>
    public Ray<Scalar> RayOf(Vector3 d) => new(P, d);

    /// <summary>The crossings of a ray with a model, nearest first; null for a mesh, and for a model that chooses among them by itself.</summary>
    public Crossed? CrossingsOf(Model model, Vector3 d) => model switch
    {
        Model<Plane> plane => Plane.Do(plane.Primitive, d),
        Model<Sphere> sphere => Sphere.Do(sphere.Primitive, d),
        Model<Aabb> box => Box.Do(box.Primitive, d),
        Model<Circle> circle => Circle.Do(circle.Primitive, d),
        Model<Triangle> triangle => Triangle.Do(triangle.Primitive, d),
        _ => model.Intersect(RayOf(d)),
    };

    private (byte R, byte G, byte B) Cast(int column, int row)
    {
        var (c, r) = Sample.Do(column, row);
        var d = Direction.Do(Towards.Do(Uc.Do(c), Ur.Do(r)));
        Model? hit = null;
        var best = Start.Do();
        var shown = double.NaN;
        for (var i = 0; i < models.Length; i++)
        {
            if (Hit.Do(models[i], d) is not { } t) continue;
            Offer(models[i], t);
            if (OffersBoth && (double?)CrossingsOf(models[i], d)?.Far is { } far && far > t && Counts(far, d)) Offer(models[i], far);
        }
        if (hit is null || !Kept.Do(shown, Depth.Do(shown, d))) return Encoded.Do(Scene.Background);
        return Encoded.Do(Shaded.Do(shown, d, hit.Color));

        void Offer(Model model, double t)
        {
            if (Better.Do(t, best)) hit = model;
            if (Lights.Do(t, best)) shown = t;
            if (Replaces.Do(t, best)) best = t;
        }
    }

    private double? HitOf(Model model, Vector3 d) => model switch
    {
        Mesh mesh => NearestOf(mesh, d),
        // Most rays pass a triangle by, which its bounds say sooner than its formula.
        Model<Triangle> { Primitive: var triangle } when !TrianglesReachOut
            && new Line(P, d).Misses(triangle.Bounds) => null,
        _ => CrossingsOf(model, d) is { } crossed ? First.Do(crossed, d)
            : model.Intersect(new Ray(P, d) { ClipRange = Camera.ClipRange, DepthPerT = Camera.Clip == ClipMode.Depth ? -(d * W) : 1 }),
    };

    /// <summary>The nearest hit of all triangles. A tree rejects triangles, also behind the camera; the steps decide which hits count.</summary>
    private double? NearestOf(Mesh mesh, Vector3 d)
    {
        if (double.IsNaN(d.X + d.Y + d.Z)) return null; // of a mistaken camera: hits nothing, and no bounds would reject it
        var along = new RaySpace<Scalar>(RayOf(d));
        return TrianglesReachOut ? Enumerable.Range(0, mesh.TriangleCount).Min(HitOf) : mesh.Tree.Nearest(P, d, HitOf);

        double? HitOf(int triangle) => First.Do(Triangle.IsChanged ? Triangle.Do(mesh[triangle], d) : mesh[triangle].Intersect(along), d);
    }

    private byte ToByte(double channel) => Byte.Do(Clamp.Do(channel));
}
