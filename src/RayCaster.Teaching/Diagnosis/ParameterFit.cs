namespace RayCaster.Teaching.Diagnosis;

/// <summary>One number of the scene or of the camera's plane that may be different in a picture.</summary>
/// <param name="Draw">The scene with another number: x is its difference, or the logarithm of its ratio, to the right one.</param>
/// <param name="Tries">The x that are tried first.</param>
internal sealed record ParameterFit(
    Func<double, (Scene Scene, FormulaProgram Program)> Draw, IReadOnlyList<double> Tries, Func<double, string> Sentence)
{
    /// <summary>A model of another size or place shows, or should show, at least this share of the wrong pixels.</summary>
    private const double Own = 0.3;

    /// <summary>How many numbers get a search for the best x.</summary>
    private const int MaxSearched = 6;

    /// <summary>How many steps that search takes.</summary>
    private const int Steps = 20;

    private static readonly double[] times = [.. Both([0.07, 0.15, 0.25, 0.35, 0.5, 0.7, 1, 1.5, 2, 3])];

    /// <summary>The number that explains a picture best.</summary>
    /// <returns>How far it is from explaining the picture, and a sentence about it.</returns>
    public static (Residual Residual, string Sentence) Find(Scene scene, SceneDifference byModels, PictureSample sample, int? threads)
    {
        var places = from model in byModels.Models
                     where model.Model >= 0
                     let shown = byModels.Models.Sum(other => other.Shows.Where(shown => shown.Model == model.Model).Sum(shown => shown.Pixels))
                     where model.Wrong + shown >= Own * sample.WrongCount
                     select model.Model;
        ParameterFit[] all = [.. OfCamera(scene), .. places.SelectMany(place => OfModel(scene, place))];
        var found = new (Residual Residual, double X)[all.Length];
        var options = new ParallelOptions { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount };
        Parallel.For(0, all.Length, options, i => found[i] = all[i].Tries.Select(x => (all[i].ResidualAt(x, sample, 0.03), x)).Min());
        int[] best = [.. Enumerable.Range(0, all.Length).OrderBy(i => found[i].Residual).Take(MaxSearched)];
        Parallel.ForEach(best, options, i => found[i] = all[i].Closest(found[i].X, sample));
        var first = best.MinBy(i => found[i].Residual);
        var (other, program) = all[first].Draw(found[first].X);
        if (sample.Lost(other, program).Any()) return (new(sample.PixelCount, sample.PixelCount), ""); // the picture shows what that does not draw
        return (found[first].Residual, all[first].Sentence(found[first].X));
    }

    /// <summary>Steps to either side of an x while that is better; otherwise halves the step.</summary>
    private (Residual, double) Closest(double x, PictureSample sample)
    {
        var best = ResidualAt(x, sample, 0.2);
        var step = Math.Abs(x) / 3;
        for (var k = 0; k < Steps; k++)
        {
            var less = ResidualAt(x - step, sample, 0.2);
            var more = ResidualAt(x + step, sample, 0.2);
            var isLess = less.CompareTo(more) < 0;
            if ((isLess ? less : more).CompareTo(best) < 0) (best, x) = isLess ? (less, x - step) : (more, x + step);
            else step /= 2;
        }
        return (ResidualAt(x, sample, 1), x);
    }

    private Residual ResidualAt(double x, PictureSample sample, double share)
    {
        var (scene, program) = Draw(x);
        return sample.Residual(scene, program, share);
    }

    private static IEnumerable<ParameterFit> OfCamera(Scene scene)
    {
        var c = scene.Camera;
        var slides = FormulaProgram.For(c);
        var size = (c.Target - c.Position).Length;
        double[] lengths = [.. Both([0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6]).Select(x => x * size)];

        yield return Of(StepKind.Camera, x => [("h", $"2·tan(angle / 2) / {Factor(x)}")],
            x => $"The same picture, about {Times(x, "large", "small")}: look at h, and at fovY.");
        yield return Of(StepKind.Camera, x => [("w", $"h·aspect / {Factor(x)}")],
            x => $"The same picture, about {Times(x, "wide", "narrow")}: look at w.");
        yield return Of(StepKind.Camera, x => [("h", $"2·tan(angle / 2) / {Factor(x)}"), ("w", $"h·aspect·{Factor(x)}")],
            x => $"The same picture, about {Times(x, "high", "low")}: look at h, while w is right.");
        yield return Of(StepKind.Light, x => [("att", $"max(0, 1 - t / (2·|T - P|·{Factor(x)}))")],
            x => $"All outlines are right, only the light: it ends at about {Number(c.FadeDistance * Math.Pow(2, x))}, " +
                $"while 2 |T − P| is {Number(c.FadeDistance)}. Look at the attenuation, and at the camera's target.");
        yield return new(x => (With(c.Position, c.Target, zNear: c.ZNear * Math.Pow(2, x)), slides), times,
            x => $"All is right if zNear is about {Number(c.ZNear * Math.Pow(2, x))}; the scene says {Number(c.ZNear)}.");
        yield return new(x => (With(c.Position, c.Target, zFar: c.ZFar * Math.Pow(2, x)), slides), times,
            x => $"All is right if zFar is about {Number(c.ZFar * Math.Pow(2, x))}; the scene says {Number(c.ZFar)}.");
        foreach (var (name, axis, of) in Axes)
        {
            yield return new(x => (With(c.Position + x * axis, c.Target), slides), lengths,
                x => $"Another camera: all is right if {name} of its position is about {Number(of(c.Position) + x)}; " +
                    $"the scene says {Number(of(c.Position))}.");
            yield return new(x => (With(c.Position, c.Target + x * axis), slides), lengths,
                x => $"Another camera: all is right if {name} of its target is about {Number(of(c.Target) + x)}; " +
                    $"the scene says {Number(of(c.Target))}.");
        }

        ParameterFit Of(StepKind step, Func<double, (string Name, string Right)[]> written, Func<double, string> sentence) => new(
            x => (scene, slides.With(written(x).Aggregate(slides[step], (all, formula) => all.With(formula.Name, formula.Right)))),
            times, sentence);

        static string Factor(double x) => Math.Pow(2, x).ToString("F12", CultureInfo.InvariantCulture);

        Scene With(Vector3 P, Vector3 T, double? zNear = null, double? zFar = null) => scene with
        {
            Camera = c.With(position: P, target: T, zNear: zNear ?? c.ZNear, zFar: zFar ?? c.ZFar),
        };
    }

    private static IEnumerable<ParameterFit> OfModel(Scene scene, int place)
    {
        var model = scene.Models[place];
        var name = ModelName.Format(scene, place);
        var slides = FormulaProgram.For(scene.Camera);
        if (Moved(model, Vector3.Zero, 1) is null) yield break;
        if (model is not Model<Plane>)
            yield return new(x => (With(Moved(model, Vector3.Zero, Math.Pow(2, x))!), slides), times,
                x => $"Only {name}: it is about {Times(x, "large", "small")}.");
        var size = (scene.Camera.Target - scene.Camera.Position).Length;
        double[] lengths = [.. Both([0.01, 0.02, 0.04, 0.08, 0.15, 0.3]).Select(x => x * size)];
        foreach (var (axisName, axis, _) in Axes)
            yield return new(x => (With(Moved(model, x * axis, 1)!), slides), lengths,
                x => $"Only {name}: it stands elsewhere, its {axisName} is about {Number(Math.Abs(x))} too {(x > 0 ? "large" : "small")}.");

        Scene With(Model other) => scene with { Models = [.. scene.Models.Select((own, i) => i == place ? other : own)] };
    }

    /// <summary>A model at another place, or of another size; null for one of another kind.</summary>
    private static Model? Moved(Model model, Vector3 by, double times)
    {
        Model? moved = model switch
        {
            Model<Plane> { Primitive: var p } => Model.Of(p with { Point = p.Point + by }),
            Model<Sphere> { Primitive: var s } => Model.Of(new Sphere(s.Center + by, s.Radius * times)),
            Model<Circle> { Primitive: var c } => Model.Of(new Circle(c.Center + by, c.Normal, c.Radius * times)),
            Model<Aabb> { Primitive: var b } => Model.Of(
                new Aabb(b.Min + by + (1 - times) / 2 * (b.Max - b.Min), b.Max + by - (1 - times) / 2 * (b.Max - b.Min))),
            Model<Triangle> { Primitive: var t } => Model.Of(new Triangle(
                Grown(t.A, t, times) + by, Grown(t.B, t, times) + by, Grown(t.C, t, times) + by)),
            _ => null,
        };
        if (moved is not null) (moved.Name, moved.Color) = (model.Name, model.Color);
        return moved;
    }

    private static Vector3 Grown(Vector3 corner, Triangle t, double times) => times * corner + (1 - times) / 3 * (t.A + t.B + t.C);

    private static (string Name, Vector3 Axis, Func<Vector3, double> Of)[] Axes =>
        [("x", new(1, 0, 0), a => a.X), ("y", new(0, 1, 0), a => a.Y), ("z", new(0, 0, 1), a => a.Z)];

    private static IEnumerable<double> Both(double[] values) => values.SelectMany<double, double>(x => [x, -x]);

    private static string Times(double x, string large, string small) => $"{Number(Math.Pow(2, Math.Abs(x)))} times too {(x > 0 ? large : small)}";

    /// <summary>Three digits.</summary>
    private static string Number(double x) =>
        x.ToString(Math.Abs(x) >= 100 ? "0" : Math.Abs(x) >= 10 ? "0.#" : "0.##", CultureInfo.InvariantCulture);
}
