namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Seeded scenes of many models, small ones and large ones. The camera is aimed at one of them, at its middle or at its outline, from
/// anywhere, also from inside of another and from the plane of its faces.</summary>
internal static class RandomCrowd
{
    /// <param name="distance">How far from the origin of space things of a few units are; any distance up to a thousand if left out.</param>
    /// <param name="least">The least number of models. With 65, they are drawn in batches.</param>
    public static Scene Make(Random random, double? distance = null, int least = 65) =>
        Some.SceneThatShows(random, random => MakeAny(random, distance, least));

    private static Scene MakeAny(Random random, double? distance, int least)
    {
        var unit = distance is null && random.Next(4) == 0 ? Math.Pow(10, random.Next(-20, 21)) : 1; // lengths of any size
        var offset = distance is { } far ? new(far, 0.7 * far, random.Next(2) * far / 3) : random.Next(4) == 0 ? Point(1000) : Vector3.Zero;
        var spread = random.Next(8) == 0 ? 0 : 0.3 + 6 * random.NextDouble(); // all of them in one spot, now and then
        var size = Math.Pow(10, -2 * random.NextDouble());
        var position = unit * (offset + Point(random.Next(4) == 0 ? 1 : 9));
        var isAligned = random.Next(3) == 0; // boxes have faces in planes that contain the camera
        var kind = isAligned ? 5 : random.Next(9); // from 5 on, all kinds
        var models = new List<Model>();
        for (var count = random.Next(least, 4 * least); models.Count < count;)
        {
            var center = offset + Point(spread);
            var r = size * (random.Next(30) == 0 ? 8 : 0.2 + random.NextDouble());
            models.Add((kind < 5 ? kind : random.Next(8)) switch
            {
                0 or 1 => Sphere(center, r),
                2 => Box(center, new(r, random.Next(9) == 0 ? 0 : r / 2, r)),
                3 => Model.Of(new Circle(unit * center, Normal(), unit * r)),
                4 => Model.Of(new Triangle(unit * center, unit * (center + r * Point(1)), unit * (center + r * Point(1)))),
                5 => random.Next(40) > 0 ? Sphere(center, r) : Model.Of(new Plane(unit * center, Normal())),
                6 => random.Next(40) > 0 ? Box(center, new(r, r, r)) : new Ball(unit * center, unit * r),
                _ => random.Next(9) > 0 ? Box(center, new(r, r, r)) : Knot(center, r),
            });
            if (random.Next(10) == 0)
                models.Insert(random.Next(models.Count), models[^1] is Model<Sphere> { Primitive: var same } ? Model.Of(same) : Sphere(center, r));
        }
        for (var i = 0; i < models.Count; i++)
            (models[i].Name, models[i].Color) = ($"{i} ({models[i].GetType().Name})", new(random.NextDouble(), random.NextDouble(), 1));

        if (random.Next(10) == 0) position = In(models[random.Next(models.Count)], random.NextDouble());
        var shown = models[random.Next(models.Count)];
        var (aim, isOutline) = (In(shown, 0.5), random.Next(4) == 0);
        if (isOutline && shown is Model<Sphere> { Primitive: var ball })
            aim += ball.Radius * (Normal() % (aim - position).Normalized).Normalized;
        else if (isOutline) aim = In(shown, random.Next(2));
        if (isAligned && random.Next(4) > 0) aim = random.Next(2) == 0 ? aim with { X = position.X, Z = position.Z } : aim with { Y = position.Y };
        if (!((aim - position).Length > 0)) aim = position + unit * new Vector3(1, 0, 0);
        var length = (aim - position).Length;
        var zNear = random.Next(4) == 0 ? length * random.NextDouble() : 0;
        var (width, height) = random.Next(8) switch
        {
            0 => (1, random.Next(1, 900)),
            1 => (random.Next(1, 900), 1),
            _ => (2 * random.Next(1, 75), 2 * random.Next(1, 55)), // even: a ray along the view
        };
        return new Scene(
            new Camera(position, aim)
            {
                Up = Math.Abs((aim - position).Normalized.Z) > 0.99 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1),
                FovY = isOutline ? Math.Pow(10, 1 - 6 * random.NextDouble()) : random.Next(5) == 0 ? 1 + 175 * random.NextDouble() : 45,
                Width = width,
                Height = height,
                ZNear = zNear,
                ZFar = random.Next(4) == 0 ? length * (1 + random.NextDouble()) : unit * 1e6,
                Bias = unit * random.Next(2) * 1e-6,
                Clip = (ClipMode)random.Next(2),
                Sample = isAligned ? PixelSample.Corner : (PixelSample)random.Next(2),
            },
            models, new Color(0.1, 0.2, 0.3));

        Vector3 Point(double range) => Some.Point(random, range);
        Vector3 Normal() => Point(1) + new Vector3(0, 0, 0.01);
        Vector3 In(Model model, double share) => model.Bounds is { } box ? box.Min + share * (box.Max - box.Min) : unit * offset;
        Model Sphere(Vector3 center, double r) => Model.Of(new Sphere(unit * center, unit * r));
        Model Box(Vector3 center, Vector3 half)
        {
            var (min, max) = (unit * (center - half), unit * (center + half));
            if (isAligned)
                (min, max) = random.Next(3) switch
                {
                    0 => (min with { X = position.X }, max with { X = position.X + unit * half.X }),
                    1 => (min with { Y = position.Y - unit * half.Y }, max with { Y = position.Y }),
                    _ => (min with { Z = position.Z }, max with { Z = position.Z + unit * half.Z }),
                };
            return Model.Of(new Aabb(min, max));
        }
        Model Knot(Vector3 center, double r)
        {
            var knot = MeshGenerator.TorusKnot(2, 3, 1, 0.4, 0.2, 12, 4);
            return new Mesh(Array.ConvertAll(knot.Vertices, p => unit * (center + r * p)), knot.Indices);
        }
    }

    /// <summary>A sphere in plain doubles.</summary>
    private sealed class Ball(Vector3 center, double radius) : Model
    {
        private readonly Model<Sphere> sphere = Of(new Sphere(center, radius));

        public override Bounds? Bounds => sphere.Bounds;

        public override double? Intersect(Ray ray) => sphere.Intersect(ray);
    }
}
