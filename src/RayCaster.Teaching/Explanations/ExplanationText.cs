namespace RayCaster.Teaching.Explanations;

/// <summary>A part of an explanation.</summary>
/// <param name="Title">What it is about; empty for the first.</param>
/// <param name="Text">Its lines, each ended by a line feed.</param>
public sealed record ExplanationSection(string Title, string Text);

/// <summary>An explanation for people: lines of at most 100 characters, mostly; numbers have six significant digits.</summary>
public sealed class ExplanationText
{
    private const int Width = 100;

    private readonly PixelExplanation pixel;
    private readonly List<(string Title, StringBuilder Text)> sections = [];

    private ExplanationText(PixelExplanation pixel) => this.pixel = pixel;

    /// <summary>The text, in lines, with the same pixel in another picture if there is one.</summary>
    public static string Format(PixelExplanation pixel, ReferenceExplanation? reference = null)
    {
        var all = new StringBuilder();
        foreach (var section in Sections(pixel, reference))
        {
            if (all.Length > 0) all.Append('\n').Wrap("", section.Title, 4, Width);
            all.Append(section.Text);
        }
        return all.ToString();
    }

    /// <summary>The same text in sections. The first, which says what the pixel shows, has no title.</summary>
    public static IReadOnlyList<ExplanationSection> Sections(PixelExplanation pixel, ReferenceExplanation? reference = null)
    {
        var writer = new ExplanationText(pixel);
        writer.Pixel();
        writer.Section("Camera", "the same for every pixel");
        writer.Steps(2, pixel.CameraSteps);
        writer.Ray();
        writer.Models();
        writer.Color();
        if (reference is not null) writer.Reference(reference);
        return [.. writer.sections.Select(section => new ExplanationSection(section.Title, section.Text.ToString()))];
    }

    /// <summary>In short, how the pixel gets its colour, and that another picture has another one there.</summary>
    public static string Gist(PixelExplanation pixel, ReferenceExplanation? reference) =>
        Gist(pixel) + (reference is { Agrees: false, Bytes: var (r, g, b) } ? $"your picture has bytes {r} {g} {b} here\n" : "");

    /// <summary>The model's first formula, the t, and the way from there to the bytes.</summary>
    private static string Gist(PixelExplanation pixel)
    {
        if (pixel.Models.FirstOrDefault(model => model.Result.Index == pixel.Winner) is not { } shown)
            return "The ray hits nothing that counts: the pixel shows the background's colour.\n";
        var writer = new ExplanationText(pixel);
        writer.Section("", "");
        writer.Steps(0, [.. shown.Steps.Take(1)]);
        foreach (var crossing in shown.Crossings.Where(crossing => crossing.Outcome == Outcome.Shows && crossing.Numbers.Length > 0))
            writer.Line(0, $"t = {crossing.Numbers} = {Digits.Format(crossing.T)}");
        writer.Steps(0, [.. pixel.ColorSteps.Take(1)]);
        var (r, g, b) = pixel.Bytes;
        writer.Line(0, $"color = attenuation · {Digits.Format(pixel.Scene.Models[shown.Result.Index].Color)} = {Digits.Format(pixel.Color)}, " +
            $"bytes {r} {g} {b}");
        return writer.Text.ToString();
    }

    /// <summary>The section that is being written.</summary>
    private StringBuilder Text => sections[^1].Text;

    private void Pixel()
    {
        Section("", "");
        var camera = pixel.Scene.Camera;
        var (r, g, b) = pixel.Bytes;
        Line(0, $"Column {pixel.Column}, line {pixel.Line} from the top (row r = {pixel.Row} from the bottom) of {camera.Width} × " +
            $"{camera.Height} pixels:");
        Line(0, $"{pixel.NameOf(pixel.Winner)}{(pixel.Winner is null ? "" : $" at t = {Digits.Format(pixel.Hit.T)}")}, bytes {r} {g} {b}");
        foreach (var note in pixel.Notes) Line(0, $"Note: {note}.");
    }

    private void Ray()
    {
        var camera = pixel.Scene.Camera;
        var ray = pixel.Ray;
        Section("Ray", camera.Sample == PixelSample.Corner ? "through the pixel's lower left corner" : "through the pixel's middle");
        Steps(2, pixel.RaySteps);
        Line(2, $"X(t) = P + t d = {Digits.Format(ray.Origin)} + t · {Digits.Format(ray.Direction)}");
        Line(2, camera.Clip == ClipMode.Depth ? $"z = t · (−d·W) = t · {Digits.Format(ray.DepthPerT)}" : "z = t");
        var least = camera.Bias == 0 ? "t ≥ 0" : $"t > bias = {Digits.Format(camera.Bias)}";
        Line(2, $"A crossing counts where {least} and zNear = {Digits.Format(camera.ZNear)} ≤ z ≤ zFar = {Digits.Format(camera.ZFar)}");
    }

    private void Models()
    {
        var others = pixel.Others;
        var count = pixel.Scene.Models.Count;
        Section("Models", others.Total > 0 ? $"{pixel.Models.Count} of {count}: what shows and what nearly does"
            : count == 0 ? "none" : "in the scene's order");
        foreach (var model in pixel.Models) Model(model);
        if (others.Total > 0)
            Line(2, $"{Digits.Count(others.Total, "other model")}: " +
                string.Join(", ", OutcomeText.All.Where(text => text.Outcome != Outcome.Shows && others[text.Outcome] > 0)
                    .Select(text => $"{Digits.Number(others[text.Outcome])} {text.Place}")));
    }

    private void Model(ModelExplanation model)
    {
        Line(2, $"{model.Name} ({model.Result.Model.Kind}): {model.Reason}");
        if (model.Beside is { } beside) Line(6, $"It shows in the pixel {(beside is "left" or "right" ? $"to the {beside}" : beside)}.");
        if (model.Result is { Model: Mesh mesh, Triangle: { } triangle })
            Line(6, $"Of its {Digits.Count(mesh.TriangleCount, "triangle")}, counted from 0, number {triangle} comes nearest:");
        Slabs(model.Slabs);
        Steps(6, [.. model.Steps.Where(step => model.Slabs.Count == 0 || step.Name is not ("t0" or "t1"))]);
        if (model.Weights is [var w, var u, var v])
            Line(6, $"divided by their sum: w = {Digits.Format(w)}, u = {Digits.Format(u)}, v = {Digits.Format(v)}");
        foreach (var crossing in model.Crossings) Crossing(model, crossing);
    }

    private void Slabs(IReadOnlyList<SlabExplanation> slabs)
    {
        if (slabs.Count == 0) return;
        List<string[]> rows =
        [
            ["slab", "B0", "B1", "t0 = (B0 − P) / d", "t1 = (B1 − P) / d", "enters", "leaves", ""],
            .. slabs.Select(slab => (string[])[slab.Axis.ToString(),
                .. new[] { slab.Lo, slab.Hi, slab.T0, slab.T1, slab.Enters, slab.Leaves }.Select(number => Digits.Format(number)), Decides(slab)]),
        ];
        var widths = Enumerable.Range(0, 8).Select(column => rows.Max(row => row[column].Length)).ToArray();
        foreach (var row in rows)
            Line(6, string.Join("  ", row.Select((cell, i) => i is 0 or 7 ? cell.PadRight(widths[i]) : cell.PadLeft(widths[i]))).TrimEnd());
    }

    private static string Decides(SlabExplanation slab) =>
        (slab.DecidesEntry, slab.DecidesExit) switch { (true, true) => "t_min, t_max", (true, _) => "t_min", (_, true) => "t_max", _ => "" };

    private void Crossing(ModelExplanation model, CrossingExplanation crossing)
    {
        if (double.IsNaN(crossing.T))
        {
            if (crossing.Untested is { } untested) Line(6, $"→ no crossing; the test fails at t = {Digits.Format(untested)}");
            return;
        }
        var t = $"t = {(crossing.Numbers.Length == 0 ? "" : $"{crossing.Numbers} = ")}{Digits.Format(crossing.T)}";
        Line(6, $"→ {t}, z = {Digits.Format(crossing.Z)}: {(model.Crossings.Count == 1 ? Word(crossing.Outcome) : crossing.Reason)}");
    }

    private static string Word(Outcome outcome) => outcome switch
    {
        Outcome.Shows => "shows",
        Outcome.Hidden => "counts, but is hidden",
        Outcome.Misses => "no crossing",
        _ => "does not count",
    };

    private void Color()
    {
        Section("Colour", pixel.Winner is { } index
            ? $"of {pixel.NameOf(index)}, {Digits.Format(pixel.Scene.Models[index].Color)}"
            : "of the background");
        Steps(2, pixel.ColorSteps);
        var (r, g, b) = pixel.Bytes;
        Line(2, $"The bytes are the levels without their fractions: {r} {g} {b}");
    }

    private void Reference(ReferenceExplanation reference)
    {
        Section("Your picture", "");
        var (r, g, b) = reference.Bytes;
        var difference = reference.Difference;
        var verdict = difference == (0, 0, 0) ? "the same" : reference.Agrees ? "the same but for rounding" : "different";
        Line(2, $"It has {r} {g} {b} here: {verdict}");
        if (difference != (0, 0, 0))
            Line(2, $"difference (its bytes less these): {difference.R:+0;−0;0} {difference.G:+0;−0;0} {difference.B:+0;−0;0}");
        if (reference.Agrees) return;
        foreach (var cause in reference.Causes) Line(2, $"Perhaps: {cause}.");
        if (reference.Causes.Count == 0) Line(2, "No crossing of this ray gives that colour.");
    }

    /// <summary>Steps in lines, with the equals signs in one column.</summary>
    private void Steps(int indent, IReadOnlyList<NamedValue> steps)
    {
        var longest = steps.Count == 0 ? 0 : steps.Max(step => step.Name.Length);
        foreach (var step in steps)
        {
            var value = step.Value switch
            {
                bool holds => holds ? "true" : "false",
                Vector3 v => Digits.Format(v),
                var number => Digits.Format((double)number),
            };
            string[] parts = step.Formula == step.Numbers || step.Numbers == value ? [step.Formula, value] : [step.Formula, step.Numbers, value];
            Text.Append(' ', indent).Append(step.Name.PadRight(longest));
            var column = indent + longest;
            foreach (var part in parts)
            {
                if (column > indent + longest && column + 3 + part.Length > Width)
                {
                    column = indent + longest;
                    Text.Append('\n').Append(' ', column);
                }
                Text.Append(step.Value is bool && ReferenceEquals(part, value) ? " is " : " = ").Append(part);
                column += 3 + part.Length;
            }
            Text.Append('\n');
        }
    }

    private void Section(string title, string about) => sections.Add((about.Length == 0 ? title : $"{title}: {about}", new()));

    private void Line(int indent, string line) => Text.Wrap(new(' ', indent), line, indent + 4, Width);
}
