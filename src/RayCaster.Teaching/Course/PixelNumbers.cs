using System.Diagnostics;
using Bytes = (byte R, byte G, byte B);
using ModelAndT = (int Model, double T);
using Pair = (double First, double Second);

namespace RayCaster.Teaching.Course;

/// <summary>What a student's bodies compute for one pixel, beside the right numbers. The first that differs is marked.</summary>
public sealed class PixelNumbers
{
    /// <summary>Much longer than any body takes for one ray.</summary>
    private static readonly TimeSpan longest = TimeSpan.FromSeconds(5);

    /// <summary>If there are more models, only those that the ray hits are listed.</summary>
    private const int ManyModels = 12;

    private const string Analytical = "analytical";

    private const string Endless = "no end: probably your code has an endless loop";

    private readonly Scene scene;
    private readonly int column, row;
    private readonly Dictionary<string, object> yours = [];
    private readonly HashSet<string> unwritten;
    private readonly Ray right;
    private readonly Hit nearest; // of what is written

    private PixelNumbers(Scene scene, int column, int row, IEnumerable<(string Name, Func<object> Compute)> bodies, Func<IEnumerable<string>> notes,
        TimeSpan limit)
    {
        (this.scene, this.column, this.row) = (scene, column, row);
        foreach (var (name, compute) in bodies)
        {
            yours[name] = Result(compute, limit);
            if (yours[name] is TimeoutException) break; // the others may wait for it
        }
        unwritten = [.. notes()];
        var camera = scene.Camera;
        if (unwritten.Contains(Slides.Bias)) camera = camera with { Bias = double.Epsilon };
        if (unwritten.Contains(Slides.ClipPlanes)) camera = camera with { ZNear = 0, ZFar = double.MaxValue };
        right = camera.RayThrough(column, row);
        var models = scene.Models.Select(model => IsWritten(model) ? model : new Mesh([], []));
        nearest = ScalarRenderer.Cast(scene with { Camera = camera, Models = [.. models] }, column, row);
        // uc and ur are local to their body. d has them, whatever its length and the sign of W.
        foreach (var (name, axis) in ((string, string)[])[(FromD("uc"), "U"), (FromD("ur"), "V")])
            if (yours.TryGetValue("d", out var d))
                yours[name] = (d, yours[axis], yours["W"]) is (Vector3 v, Vector3 along, Vector3 back) ? v * along / Math.Abs(v * back) : d;
    }

    /// <summary>Prints the numbers; returns the program's exit code.</summary>
    /// <param name="pixel">The column, the line from the top, and perhaps --hint with its level.</param>
    /// <param name="bodies">
    /// Calls of the bodies for c and r. They give: "a + b" and so on of the vectors (1, 2, 3) and (4, −5, 6), "a after a + b" and so on, "W", "U",
    /// "V", "d" as three doubles; "h", "w", "attenuation" as one; for the models "0", "1" and so on each t with which they call Hit, and whether it
    /// counts, for a sphere by its analytical solution as "0 analytical"; "hit" as the model's index and t; and "bytes".
    /// </param>
    /// <param name="notes">The slides of the called bodies that are not written.</param>
    public static int Print(
        Scene scene, string[] pixel, Func<int, int, IEnumerable<(string Name, Func<object> Compute)>> bodies, Func<IEnumerable<string>> notes) =>
        Print(Console.Out, scene, pixel, bodies, notes);

    internal static int Print(
        TextWriter output, Scene scene, string[] pixel, Func<int, int, IEnumerable<(string Name, Func<object> Compute)>> bodies,
        Func<IEnumerable<string>> notes, TimeSpan? limit = null)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var level = pixel is [_, _, "--hint", var hint] ? hint : pixel.Length == 2 ? "answer" : "";
        if (level is not ("symptom" or "question" or "answer")
            || !int.TryParse(pixel[0], NumberStyles.None, CultureInfo.InvariantCulture, out var column) || column >= width
            || !int.TryParse(pixel[1], NumberStyles.None, CultureInfo.InvariantCulture, out var line) || line >= height)
        {
            output.WriteLine($"After --pixel write a column from 0 to {width - 1}, a line from 0 to {height - 1}, counted from the top, " +
                "and perhaps --hint symptom, --hint question or --hint answer");
            return 2;
        }
        var row = height - 1 - line;
        output.WriteLine($"Column {column}, line {line} from the top: c = {column}, r = {row}");
        var foundWrong = false;
        var last = "";
        var shown = new SortedSet<int>(); // the steps
        foreach (var part in new PixelNumbers(scene, column, row, bodies(column, row), notes, limit ?? longest).Lines())
        {
            var (name, slide, mine, rightly) = part;
            if (mine == null && slide == last) continue;
            last = slide;
            if (mine != null) shown.Add(Slides.StepOf(slide));
            if (!part.IsTold) continue;
            var text = mine == null ? $"not written yet. Step {Slides.StepOf(slide)}, slide \"{slide}\"" : Compared(mine, rightly);
            if (rightly != null && !foundWrong) text += ": the first wrong value" + (level == "symptom" ? "" : $". Slide \"{slide}\"");
            output.WriteLine($"  {name}: {text}");
            if (rightly != null && !foundWrong)
                foreach (var between in part.Between.Where(between => between.Yours != null || level == "answer"))
                    output.WriteLine($"    {between.Name}: {Compared(between.Yours, between.Right)}");
            foundWrong |= rightly != null;
            if (mine == Endless) break;
        }
        var steps = shown.Where(step => step > 0);
        output.WriteLine(foundWrong ? "Numbers after the first wrong one may be wrong because of it."
            : !steps.Any() ? "No number is yours: what this pixel asks for is not written yet."
            : $"Your numbers of {(steps.Count() == 1 ? "step" : "the steps")} {string.Join(", ", steps)} are right for this pixel. " +
                $"The tests of step {steps.Last()} ask more.");
        return foundWrong ? 1 : 0;

        string? Compared(string? mine, string? rightly) => mine == null ? $"right {rightly}"
            : rightly == null ? mine
            : level == "answer" ? $"yours {mine}, right {rightly}"
            : $"yours {mine}, not right";
    }

    private static object Result(Func<object> compute, TimeSpan limit)
    {
        var task = Task.Run(compute);
        try
        {
            return !task.Wait(limit) ? new TimeoutException()
                : task.Result is ValueTuple<double, double, double> v ? new Vector3(v.Item1, v.Item2, v.Item3)
                : task.Result;
        }
        catch (AggregateException e) // of a body
        {
            return e.InnerException!;
        }
    }

    private bool IsWritten(Model model) => ShapeKind.Find(model.Kind)?.Slide is not { } slide
        || !Slides.Steps[Slides.StepOf(slide) - 1].Slides.Any(unwritten.Contains);

    /// <summary>The text for each number.</summary>
    /// <param name="Yours">Null if it is not written yet.</param>
    /// <param name="Right">Null if yours is right.</param>
    private sealed record Line(string Name, string Slide, string? Yours, string? Right)
    {
        /// <summary>The numbers on the way to it, told if it is the first wrong one; yours is null where it cannot be had.</summary>
        public IEnumerable<Line> Between { get; init; } = [];

        /// <summary>Whether it is shown: an example that is right need not be, once there are rays.</summary>
        public bool IsTold { get; init; } = true;
    }

    /// <summary>What is asked of each program, whatever its scene.</summary>
    private IEnumerable<Line> Examples()
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        foreach (var (name, result) in ((string, object)[])
            [("a + b", a + b), ("a − b", a - b), ("2 a", 2 * a), ("a × b", a % b), ("a · b", a * b), ("|a|", a.Length)])
        {
            yield return LineOf(name, Slides.Vectors, result) with { Name = $"{name} for a = {Digits.Format(a)}, b = {Digits.Format(b)}" };
            foreach (var (operand, value) in ((string, object)[])[($"a after {name}", a), ($"b after {name}", b)])
                if (yours.GetValueOrDefault(operand) is Vector3 && LineOf(operand, Slides.Vectors, value) is { Right: not null } changed)
                    yield return changed;
        }
        Vector3 P = new(1, 2, 3), d = new(0.48, 0.6, -0.64);
        var which = $"for P = {Digits.Format(P)}, d = {Digits.Format(d)}";
        yield return LineOf("X(5)", Slides.Ray, P + 5 * d) with { Name = $"X(5) {which}" };
        foreach (var (t, bias) in ((double, double)[])[(1, 2), (2, 2), (3, 2), (-1, 0), (0, 0)])
            yield return OfCounts($"isAhead of Counts({Digits.Format(t)}) for Bias = {bias}", Slides.Bias, new(bias, -1e9, 1e9), t, 1);
        foreach (var t in (double[])[4, 16, 10, 6, 14])
            yield return OfCounts($"isBetween of Counts({t}) for ZNear = 3, ZFar = 7, DepthPerT = 0.5", Slides.ClipPlanes, new(-1e9, 3, 7), t, 0.5);
        foreach (var (calls, hit) in ((string, string)[])[("Hit(5), Hit(3), Hit(4)", "3, that of call 2"), ("Hit(3), Hit(3)", "3, that of call 1"),
            ("Hit(−3), Hit(NaN)", "Infinity, null")]) yield return LineOf($"HitParameter and HitModel after {calls}", Slides.Ray, hit);
        var plane = new Plane(new(3, 3, -1), new(1, 2, -1));
        var example = LineOf("plane", Slides.RayPlane, 0); // where it is not written
        if (example.Yours != null) example = OfCalls("", "plane", Model.Of(plane), Slides.RayPlane, new(P, d));
        yield return example with { Name = $"t of a plane with Q = {Digits.Format(plane.Point)}, n = {Digits.Format(plane.Normal)} {which}" };

        Line OfCounts(string name, string slide, ClipRange range, double t, double depthPerT) =>
            LineOf(name, slide, range.CountsMask<Scalar>(t, depthPerT) != 0);
    }

    private IEnumerable<Line> Lines()
    {
        var hasRays = !unwritten.Overlaps([Slides.Vectors, Slides.Camera]);
        foreach (var example in Examples())
            if (example.Yours != null || !hasRays) yield return example with { IsTold = !hasRays || example.Right != null };
        foreach (var step in PixelSteps.OfCamera(scene.Camera))
        {
            yield return LineOf(step.Name, Slides.Camera, step.Value);
            if (yours.GetValueOrDefault("W") is Exception) yield break; // there is no camera
        }
        if (!hasRays) yield break;
        foreach (var step in PixelSteps.OfRay(scene.Camera, column, row).Where(step => step.Name != "pixel"))
            yield return LineOf(step.Name == "d" ? "d" : FromD(step.Name), Slides.PixelTranslation, step.Value);
        if (unwritten.Contains(Slides.PixelTranslation) || yours.GetValueOrDefault("d") is Exception) yield break;

        foreach (var name in yours.Keys.Where(name => name.StartsWith("Slab(", StringComparison.Ordinal)))
        {
            double[] of = [.. name[5..^1].Split(", ").Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
            if (LineOf(name, Slides.BoxParameters, BodyNumbers.Slab(of[0], of[1], of[2], of[3])) is { Right: not null } wrong) yield return wrong;
        }
        foreach (var (i, model) in scene.Models.Index())
        {
            var name = $"t of {ModelName.Typed(scene, i)}";
            foreach (var line in OfModel(name, model, i)) yield return line;
            if (!yours.ContainsKey($"{i} {Analytical}") || unwritten.Contains(Slides.SphereAnalytical)) continue;
            var other = OfCalls($"{name} by AnalyticalSolution", $"{i} {Analytical}", model, Slides.SphereAnalytical, right);
            yield return other with { IsTold = other.Right != null }; // it draws nothing
        }
        yield return LineOf("hit", Slides.Ray, new ModelAndT(nearest.Model, nearest.T));
        var lit = scene.Shade(nearest); // or the background
        if (nearest.Model >= 0)
        {
            yield return LineOf("attenuation", Slides.Shading, scene.Attenuation<Scalar>(nearest.T).Value);
            yield return LineOf("Shade", Slides.Shading, new Vector3(lit.R, lit.G, lit.B)) with { Name = "red, green and blue of Shade" };
        }
        var isUnlit = nearest.Model >= 0 && unwritten.Contains(Slides.Shading);
        yield return LineOf("bytes", Slides.RayCasting, (isUnlit ? scene.Models[nearest.Model].Color : lit).ToBytes());
    }

    /// <summary>Which t the model has, and whether one counts that should not, or the other way.</summary>
    private IEnumerable<Line> OfModel(string name, Model model, int index)
    {
        var slide = model is Model<Aabb> ? Slides.BoxTest : ShapeKind.Find(model.Kind)?.Slide ?? model.Kind;
        var line = IsWritten(model) ? OfCalls(name, $"{index}", model, slide, right) : new(name, slide, null, null);
        if (scene.Models.Count <= ManyModels || line.Yours != HitText(double.PositiveInfinity) || line.Right != null) yield return line;
        var calls = IsWritten(model) ? yours.GetValueOrDefault($"{index}") as (double T, bool Counts)[] : null;
        foreach (var (t, counts) in (calls ?? []).Where(call => call.Counts != right.Counts(call.T)).Take(1))
            yield return new($"Counts({Digits.Format(t)})", $"{Slides.Bias}\" or \"{Slides.ClipPlanes}", $"{counts}", $"{!counts}");
    }

    /// <summary>The least t that counts by the right rule of those with which a body calls Hit, or the second where only that is wrong.</summary>
    private Line OfCalls(string name, string key, Model model, string slide, Ray ray)
    {
        var rightly = model.Intersect(ray) ?? double.PositiveInfinity;
        if (yours.GetValueOrDefault(key) is not (double T, bool Counts)[] calls)
            return LineOf(key, slide, rightly) is { Yours: not null } wrong ? wrong with { Name = name, Right = HitText(rightly) }
                : new(name, slide, null, null);
        double[] ts = [.. calls.Select(call => call.T)];
        var mine = ts.Where(ray.Counts).DefaultIfEmpty(double.PositiveInfinity).Min();
        var refused = !double.IsInfinity(mine) ? ""
            : ts.Length > 0 ? $" (Hit was called with t = {string.Join(" and t = ", ts.Select(Digits.Format))})"
            : double.IsInfinity(rightly) ? "" : " (Hit was not called)";
        var numbers = BodyNumbers.Of(model, ray.Origin, ray.Direction, slide == Slides.SphereAnalytical);
        var slabs = yours.GetValueOrDefault($"{key} slabs") as double[] ?? [];
        if (slabs.Take(6).Zip(numbers).Any(slab => !IsSame(slab.First, slab.Second.Value))) slide = Slides.BoxParameters;
        var between = Between(numbers, BodyNumbers.Yours(numbers, ts, slabs), slide);
        if (!IsSame(mine, rightly)) return new(name, slide, HitText(mine) + refused, HitText(rightly)) { Between = between };
        if (BodyNumbers.RootsOf(numbers) is var (near, far) && ts is [var a, var b] && !IsSame(new Pair(ts.Min(), ts.Max()), new Pair(near, far)))
            return new($"both {name}", slide, Text(new Pair(a, b)), Text(new Pair(near, far))) { Between = between };
        return between.FirstOrDefault(number => number is { Yours: not null, Right: not null }) is { } unseen
            ? unseen with { Name = $"{unseen.Name}, on the way to {name}" } : new(name, slide, HitText(mine) + refused, null);
    }

    private static IEnumerable<Line> Between(
        IReadOnlyList<(string Name, object Value)> right, IEnumerable<(string Name, object Value)> yours, string slide)
    {
        var mine = yours.ToLookup(number => number.Name, number => number.Value);
        foreach (var (name, value) in right)
            if (mine[name].FirstOrDefault() is not { } own) yield return new(name, slide, null, BodyNumbers.Text(value));
            else if (BodyNumbers.IsSame(own, value)) yield return new(name, slide, BodyNumbers.Text(own), null);
            else yield return new(name, slide, BodyNumbers.Text(own) + BodyNumbers.Which(right, name, own), BodyNumbers.Text(value));
    }

    private Line LineOf(string name, string slide, object rightly) =>
        unwritten.Contains(Slides.Vectors) ? new(name, Slides.Vectors, null, null)
        : unwritten.Contains(slide) ? new(name, slide, null, null)
        : yours.GetValueOrDefault(name) is not { } mine ? new(name, slide, Endless, Text(rightly))
        : new(name, slide, Text(mine), IsSame(mine, rightly) ? null : Text(rightly));

    private static bool IsSame(object a, object b) => (a, b) switch
    {
        (ModelAndT v, ModelAndT w) => v.Model == w.Model && IsSame(v.T, w.T),
        (Pair v, Pair w) => IsSame(v.First, w.First) && IsSame(v.Second, w.Second),
        (Bytes v, Bytes w) => PictureJudge.IsNear(v, w),
        (bool or string, bool or string) => a.Equals(b),
        _ => BodyNumbers.IsSame(a, b),
    };

    private string Text(object value) => value switch
    {
        double number => Digits.Format(number),
        Vector3 vector => Digits.Format(vector),
        Pair pair => $"({Digits.Format(pair.First)}, {Digits.Format(pair.Second)})",
        ModelAndT hit => hit.Model < 0 ? "none" : $"{ModelName.Typed(scene, hit.Model)} at t = {Digits.Format(hit.T)}",
        Bytes bytes => $"({bytes.R}, {bytes.G}, {bytes.B})",
        TimeoutException => Endless,
        Exception e => $"{e.GetType().Name}, {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}{Place(e)}",
        _ => $"{value}",
    };

    private static string FromD(string name) => $"{name} (from your d)";

    private static string HitText(double t) => double.IsPositiveInfinity(t) ? "no hit" : Digits.Format(t);

    private static string Place(Exception e) =>
        new StackTrace(e, fNeedFileInfo: true).GetFrames().FirstOrDefault(frame => frame.GetFileLineNumber() > 0) is { } place
            ? $" (in {Path.GetFileName(place.GetFileName())}, line {place.GetFileLineNumber()})" : "";
}
