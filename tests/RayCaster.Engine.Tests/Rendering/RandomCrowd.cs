namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Seeded scenes of so many models that they are drawn in batches: small ones and large ones, in one place or around the camera.</summary>
internal static class RandomCrowd
{
    public static Scene Make(Random random)
    {
        double Next(double range) => range * (2 * random.NextDouble() - 1);
        Vector3 Some(double range) => new(Next(range), Next(range), Next(range));

        var unit = random.Next(4) == 0 ? Math.Pow(10, random.Next(-20, 21)) : 1; // lengths of any size
        var offset = random.Next(4) == 0 ? Some(1000) : Vector3.Zero;            // far from the origin of space, for the size of things
        var spread = random.Next(5) == 0 ? 0 : 0.3 + 6 * random.NextDouble();    // all of them in one spot, now and then
        var size = Math.Pow(10, -2 * random.NextDouble());
        var kind = random.Next(8);                                               // from 5 on, all kinds
        var models = new List<Model>();
        var count = random.Next(65, 260);
        while (models.Count < count)
        {
            var center = offset + Some(spread);
            var r = size * (random.Next(30) == 0 ? 8 : 0.2 + random.NextDouble());
            models.Add((kind < 5 ? kind : random.Next(7)) switch
            {
                0 or 1 => Sphere(center, r),
                2 => Box(center, new(r, random.Next(9) == 0 ? 0 : r / 2, r)),
                3 => Model.Of(new Circle(unit * center, Some(1) + new Vector3(0, 0, 0.01), unit * r)),
                4 => Model.Of(new Triangle(unit * center, unit * (center + r * Some(1)), unit * (center + r * Some(1)))),
                5 => random.Next(40) > 0 ? Sphere(center, r) : Model.Of(new Plane(unit * center, Some(1) + new Vector3(0, 0, 0.01))),
                _ => random.Next(40) > 0 ? Box(center, new(r, r, r)) : new Ball(unit * center, unit * r),
            });
            if (random.Next(10) == 0)
                models.Insert(random.Next(models.Count), models[^1] is Model<Sphere> { Primitive: var same } ? Model.Of(same) : Sphere(center, r));
        }
        for (var i = 0; i < models.Count; i++) models[i].Name = $"{i} ({models[i].GetType().Name})";

        var position = offset +
            random.Next(4) switch { 0 => Some(1), 1 => spread * new Vector3(0.9, 0.1, 0.2) + new Vector3(0.01, 0, 0), _ => Some(9) };
        var target = random.Next(6) == 0 ? position + Some(1) + new Vector3(0.1, 0, 0) : offset + new Vector3(0.1, 0, 0);
        var up = Math.Abs((target - position).Normalized.Z) > 0.99 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
        var zNear = random.Next(3) == 0 ? 6 * random.NextDouble() : 0;
        var zFar = random.Next(3) == 0 ? zNear + 8 * random.NextDouble() + 0.01 : 1e6;
        var (width, height) = random.Next(8) switch
        {
            0 => (1, random.Next(1, 900)),
            1 => (random.Next(1, 900), 1),
            _ => (random.Next(1, 150), random.Next(1, 110)),
        };
        var fovY = random.Next(5) == 0 ? 1 + 175 * random.NextDouble() : 45;
        return new Scene(
            new Camera(unit * position, unit * target)
            {
                Up = up,
                FovY = fovY,
                Width = width,
                Height = height,
                ZNear = unit * zNear,
                ZFar = unit * zFar,
                Bias = unit * random.Next(2) * 1e-6,
                Clip = (ClipMode)random.Next(2),
                Sample = (PixelSample)random.Next(2),
            },
            models, new Color(0.1, 0.2, 0.3));

        Model Sphere(Vector3 center, double r) => Model.Of(new Sphere(unit * center, unit * r));
        Model Box(Vector3 center, Vector3 half) => Model.Of(new Aabb(unit * (center - half), unit * (center + half)));
    }

    /// <summary>A sphere in plain doubles.</summary>
    private sealed class Ball(Vector3 center, double radius) : Model
    {
        private readonly Model<Sphere> sphere = Of(new Sphere(center, radius));

        public override double? Intersect(Ray ray) => sphere.Intersect(ray);
    }
}
