using System.Diagnostics;
using Bytes = (byte R, byte G, byte B);
using ModelAndT = (int Model, double T);

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
        if (unwritten.Contains(Slides.Bias)) camera = camera.With(bias: double.Epsilon);
        if (unwritten.Contains(Slides.ClipPlanes)) camera = camera.With(zNear: 0, zFar: double.MaxValue);
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
        foreach (var (name, slide, mine, rightly) in new PixelNumbers(scene, column, row, bodies(column, row), notes,
            limit ?? longest).Lines())
        {
            if (mine == null && slide == last) continue;
            last = slide;
            var text = mine == null ? $"not written yet. Step {Slides.StepOf(slide)}, slide \"{slide}\""
                : rightly == null ? mine
                : level == "answer" ? $"yours {mine}, right {rightly}"
                : $"yours {mine}, not right";
            if (rightly != null && !foundWrong) text += ": the first wrong value" + (level == "symptom" ? "" : $". Slide \"{slide}\"");
            output.WriteLine($"  {name}: {text}");
            foundWrong |= rightly != null;
            if (mine == Endless) break;
        }
        output.WriteLine(foundWrong ? "Numbers after the first wrong one may be wrong because of it." : "None of these numbers is wrong.");
        return foundWrong ? 1 : 0;
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
    private sealed record Line(string Name, string Slide, string? Yours, string? Right);

    private IEnumerable<Line> Lines()
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        foreach (var (name, result) in ((string, object)[])
            [("a + b", a + b), ("a − b", a - b), ("2 a", 2 * a), ("a × b", a % b), ("a · b", a * b), ("|a|", a.Length)])
        {
            if (Of(name, Slides.Vectors, result) is { Right: not null } wrong)
                yield return wrong with { Name = $"{name} for a = {Digits.Format(a)}, b = {Digits.Format(b)}" };
            foreach (var (operand, value) in ((string, object)[])[($"a after {name}", a), ($"b after {name}", b)])
                if (yours.GetValueOrDefault(operand) is Vector3 && Of(operand, Slides.Vectors, value) is { Right: not null } changed)
                    yield return changed;
        }

        foreach (var step in PixelSteps.OfCamera(scene.Camera))
        {
            yield return Of(step.Name, Slides.Camera, step.Value);
            if (yours.GetValueOrDefault("W") is Exception) yield break; // there is no camera
        }
        foreach (var step in PixelSteps.OfRay(scene.Camera, column, row).Where(step => step.Name != "pixel"))
            yield return Of(step.Name == "d" ? "d" : FromD(step.Name), Slides.PixelTranslation, step.Value);
        if (unwritten.Overlaps([Slides.Vectors, Slides.Camera, Slides.PixelTranslation]) || yours.GetValueOrDefault("d") is Exception) yield break;

        foreach (var (i, model) in scene.Models.Index())
        {
            foreach (var line in OfModel(model, i)) yield return line;
            if (OfAnalytical(model, i) is { } analytical) yield return analytical;
        }
        yield return Of("hit", Slides.Ray, new ModelAndT(nearest.Model, nearest.T));
        if (nearest.Model >= 0) yield return Of("attenuation", Slides.Shading, scene.Attenuation<Scalar>(nearest.T).Value);
        var isUnlit = nearest.Model >= 0 && unwritten.Contains(Slides.Shading);
        var color = isUnlit ? scene.Models[nearest.Model].Color : scene.Shade(nearest);
        yield return Of("bytes", Slides.RayCasting, color.ToBytes());
    }

    /// <summary>Which t the model has, and whether one counts that should not, or the other way.</summary>
    private IEnumerable<Line> OfModel(Model model, int index)
    {
        var name = $"t of {ModelName.Typed(scene, index)}";
        var slide = ShapeKind.Find(model.Kind)?.Slide ?? model.Kind;
        var rightly = model.Intersect(right) ?? double.PositiveInfinity;
        if (!IsWritten(model) || yours.GetValueOrDefault($"{index}") is not (double T, bool Counts)[] calls)
        {
            yield return IsWritten(model)
                ? Of($"{index}", slide, rightly) with { Name = name, Right = HitText(rightly) } : new(name, slide, null, null);
            yield break;
        }
        var mine = NearestOf(calls);
        var refused = double.IsInfinity(mine) && calls.Length > 0 ? $" (Hit was called with t = {Digits.Format(calls[0].T)})" : "";
        if (scene.Models.Count <= ManyModels || double.IsFinite(mine) || !IsSame(mine, rightly))
            yield return new(name, slide, HitText(mine) + refused, IsSame(mine, rightly) ? null : HitText(rightly));
        foreach (var (t, counts) in calls.Where(call => call.Counts != right.Counts(call.T)).Take(1))
            yield return new($"Counts({Digits.Format(t)})", $"{Slides.Bias}\" or \"{Slides.ClipPlanes}", $"{counts}", $"{!counts}");
    }

    /// <summary>The other solution of a sphere, which draws nothing; null where it is right or not written.</summary>
    private Line? OfAnalytical(Model model, int index)
    {
        var slide = Slides.SphereAnalytical;
        if (unwritten.Contains(slide) || !yours.TryGetValue($"{index} {Analytical}", out var mine)) return null;
        var name = $"t of {ModelName.Typed(scene, index)} by AnalyticalSolution";
        var rightly = model.Intersect(right) ?? double.PositiveInfinity;
        if (mine is not (double T, bool Counts)[] calls) return new(name, slide, Text(mine), HitText(rightly));
        var t = NearestOf(calls);
        return IsSame(t, rightly) ? null : new(name, slide, HitText(t), HitText(rightly));
    }

    /// <summary>The least t that counts by the right rule; infinite for none.</summary>
    private double NearestOf((double T, bool Counts)[] calls) =>
        calls.Select(call => call.T).Where(right.Counts).DefaultIfEmpty(double.PositiveInfinity).Min();

    private Line Of(string name, string slide, object rightly) =>
        unwritten.Contains(Slides.Vectors) ? new(name, Slides.Vectors, null, null)
        : unwritten.Contains(slide) ? new(name, slide, null, null)
        : yours.GetValueOrDefault(name) is not { } mine ? new(name, slide, Endless, Text(rightly))
        : new(name, slide, Text(mine), IsSame(mine, rightly) ? null : Text(rightly));

    private static bool IsSame(object a, object b) => (a, b) switch
    {
        (double x, double y) => x == y || Math.Abs(x - y) <= 1e-6 * (1 + Math.Min(Math.Abs(x), Math.Abs(y))),
        (Vector3 v, Vector3 w) => IsSame(v.X, w.X) && IsSame(v.Y, w.Y) && IsSame(v.Z, w.Z),
        (ModelAndT v, ModelAndT w) => v.Model == w.Model && IsSame(v.T, w.T),
        (Bytes v, Bytes w) => PictureJudge.IsNear(v, w),
        _ => false,
    };

    private string Text(object value) => value switch
    {
        double number => Digits.Format(number),
        Vector3 vector => Digits.Format(vector),
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
