namespace RayCaster.Benchmarks.NaiveClass;

// A peer: the lab as most hand it in, with Vector3 a class, a list of models and simple ifs. It shares nothing with the project. Struct and class are apart in one word, so that the two files tell what that word costs.

internal sealed class Vector3(double x, double y, double z)
{
    public double X = x, Y = y, Z = z;

    public double Length => Math.Sqrt(this * this);

    public Vector3 Normalized => this * (1 / Length);

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vector3 operator *(Vector3 a, double b) => new(a.X * b, a.Y * b, a.Z * b);

    public static double operator *(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Vector3 operator %(Vector3 a, Vector3 b) =>
        new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
}

internal sealed class Ray(Vector3 origin, Vector3 direction, double zPerT, Camera camera)
{
    public Vector3 Origin = origin, Direction = direction;
    public double HitParameter = double.MaxValue;
    public Model? HitModel;

    public void Hit(double t, Model model)
    {
        if (t >= HitParameter) return;
        HitParameter = t;
        HitModel = model;
    }

    public bool Counts(double t) => t > camera.Bias && t * zPerT >= camera.ZNear && t * zPerT <= camera.ZFar;
}

internal abstract class Model
{
    public Vector3 Color = new(1, 1, 1);

    public abstract void Intersect(Ray ray);
}

internal sealed class Plane(Vector3 q, Vector3 n) : Model
{
    public override void Intersect(Ray ray)
    {
        var dn = ray.Direction * n;
        if (dn == 0) return;
        var t = (q - ray.Origin) * n / dn;
        if (ray.Counts(t)) ray.Hit(t, this);
    }
}

internal sealed class Sphere(Vector3 center, double radius) : Model
{
    public override void Intersect(Ray ray)
    {
        var l = center - ray.Origin;
        var tca = l * ray.Direction;
        var square = l * l - tca * tca;
        if (square > radius * radius) return;
        var thc = Math.Sqrt(radius * radius - square);
        if (ray.Counts(tca - thc)) ray.Hit(tca - thc, this);
        else if (ray.Counts(tca + thc)) ray.Hit(tca + thc, this);
    }
}

internal sealed class Box(Vector3 min, Vector3 max) : Model
{
    public override void Intersect(Ray ray)
    {
        double tMin = double.MinValue, tMax = double.MaxValue;
        if (!Slab(ray.Origin.X, ray.Direction.X, min.X, max.X, ref tMin, ref tMax)) return;
        if (!Slab(ray.Origin.Y, ray.Direction.Y, min.Y, max.Y, ref tMin, ref tMax)) return;
        if (!Slab(ray.Origin.Z, ray.Direction.Z, min.Z, max.Z, ref tMin, ref tMax)) return;
        if (ray.Counts(tMin)) ray.Hit(tMin, this);
        else if (ray.Counts(tMax)) ray.Hit(tMax, this);
    }

    private static bool Slab(double origin, double direction, double lo, double hi, ref double tMin, ref double tMax)
    {
        if (direction == 0) return origin >= lo && origin <= hi;
        var t0 = (lo - origin) / direction;
        var t1 = (hi - origin) / direction;
        if (t0 > t1) (t0, t1) = (t1, t0);
        if (t0 > tMin) tMin = t0;
        if (t1 < tMax) tMax = t1;
        return tMin <= tMax;
    }
}

internal sealed class Circle(Vector3 center, Vector3 n, double radius) : Model
{
    public override void Intersect(Ray ray)
    {
        var dn = ray.Direction * n;
        if (dn == 0) return;
        var t = (center - ray.Origin) * n / dn;
        if (!ray.Counts(t)) return;
        var x = ray.Origin + ray.Direction * t;
        if ((x - center).Length <= radius) ray.Hit(t, this);
    }
}

internal sealed class Triangle(Vector3 a, Vector3 b, Vector3 c) : Model
{
    public override void Intersect(Ray ray)
    {
        var e1 = b - a;
        var e2 = c - a;
        var p = ray.Direction % e2;
        var determinant = e1 * p;
        if (determinant == 0) return;
        var s = ray.Origin - a;
        var u = s * p / determinant;
        if (u < 0 || u > 1) return;
        var q = s % e1;
        var v = ray.Direction * q / determinant;
        if (v < 0 || u + v > 1) return;
        var t = e2 * q / determinant;
        if (ray.Counts(t)) ray.Hit(t, this);
    }
}

internal sealed class Camera(Vector3 position, Vector3 target, Vector3 up, double fovY, int width, int height)
{
    public double Bias, ZNear, ZFar;

    public Vector3 Background = new(0, 0, 0);

    public List<Model> Models = [];

    /// <summary>Draws the pixels first, first + step, first + 2 step and so on, top line first; with step 1 the whole picture.</summary>
    public void Render(byte[] rgb, int first, int step)
    {
        var w = (position - target).Normalized;
        var u = (up % w).Normalized;
        var v = w % u;
        var planeHeight = 2 * Math.Tan(fovY * Math.PI / 360);
        var planeWidth = planeHeight * width / height;
        var reach = 2 * (target - position).Length;
        for (var pixel = (long)first; pixel < (long)width * height; pixel += step)
        {
            var column = (int)(pixel % width);
            var row = height - 1 - (int)(pixel / width);
            var ur = planeHeight * row / height - planeHeight / 2;
            var uc = planeWidth * column / width - planeWidth / 2;
            var direction = (u * uc + v * ur - w).Normalized;
            var ray = new Ray(position, direction, -(direction * w), this);
            foreach (var model in Models) model.Intersect(ray);
            var color = Background;
            if (ray.HitModel != null) color = ray.HitModel.Color * Math.Max(0, 1 - ray.HitParameter / reach);
            rgb[3 * pixel] = ToByte(color.X);
            rgb[3 * pixel + 1] = ToByte(color.Y);
            rgb[3 * pixel + 2] = ToByte(color.Z);
        }
    }

    private static byte ToByte(double channel) => (byte)(Math.Min(1, channel) * 255 + 0.5);

    /// <summary>The same scene in the peer's own types; its meshes are triangles in the list.</summary>
    public static Camera Of(Scene scene)
    {
        var from = scene.Camera;
        var camera = new Camera(Of(from.Position), Of(from.Target), Of(from.Up), from.FovY, from.Width, from.Height)
        {
            Bias = from.Bias,
            ZNear = from.ZNear,
            ZFar = from.ZFar,
            Background = Of(scene.Background),
        };
        foreach (var model in scene.Models)
        {
            if (model is Mesh mesh)
            {
                for (var i = 0; i < mesh.TriangleCount; i++) Add(Of(mesh[i]));
            }
            else
            {
                Add(model switch
                {
                    Model<RayCaster.Plane> m => new Plane(Of(m.Primitive.Point), Of(m.Primitive.Normal)),
                    Model<RayCaster.Sphere> m => new Sphere(Of(m.Primitive.Center), m.Primitive.Radius),
                    Model<Aabb> m => new Box(Of(m.Primitive.Min), Of(m.Primitive.Max)),
                    Model<RayCaster.Circle> m => new Circle(Of(m.Primitive.Center), Of(m.Primitive.Normal), m.Primitive.Radius),
                    Model<RayCaster.Triangle> m => Of(m.Primitive),
                    _ => throw new NotSupportedException($"the peer has no {model.GetType().Name}"),
                });
            }

            void Add(Model copy)
            {
                copy.Color = Of(model.Color);
                camera.Models.Add(copy);
            }
        }
        return camera;
    }

    private static Triangle Of(RayCaster.Triangle t) => new(Of(t.A), Of(t.B), Of(t.C));

    private static Vector3 Of(RayCaster.Vector3 v) => new(v.X, v.Y, v.Z);

    private static Vector3 Of(Color c) => new(c.R, c.G, c.B);
}
