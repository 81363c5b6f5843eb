using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>Draws pixels of a scene by formulas. Of a program that differs from the first one by an edit, it computes only what the edit reaches.
/// </summary>
/// <remarks>Not for several threads.</remarks>
internal sealed class FormulaEvaluator
{
    /// <summary>A mesh with more triangles is searched through its tree, and its triangles are crossed as the definition says.</summary>
    public const int MaxTriangles = 100;

    private readonly Scene scene;
    private readonly int shown, count; // pixels: those that are drawn, and with the last one again and again as many as the arithmetic needs
    private readonly BatchArithmetic arithmetic;
    private readonly Batch[] givens;
    private readonly Part[] parts;
    private readonly Dictionary<(int Part, FormulaSection Section), Batch[]> rightFrames = [];
    private readonly Batch[] ofShape = new Batch[Symbol.Max], ofRule = new Batch[Symbol.Max]; // frames for intermediate results
    private readonly State right;

    /// <param name="pixels">Columns from the left and lines from the top.</param>
    /// <param name="program">The program that others are edits of.</param>
    public FormulaEvaluator(Scene scene, IReadOnlyList<(int X, int Y)> pixels, FormulaProgram program)
    {
        this.scene = scene;
        shown = pixels.Count;
        if (shown % Vector<double>.Count is > 0 and var over) pixels = [.. pixels, .. Enumerable.Repeat(pixels[^1], Vector<double>.Count - over)];
        count = pixels.Count;
        arithmetic = new(count) { Keeps = true };
        givens = GivensOf(scene.Camera);
        givens[Symbol.Of("x").Place] = new([.. pixels.Select(pixel => (double)pixel.X)]);
        givens[Symbol.Of("y").Place] = new([.. pixels.Select(pixel => (double)pixel.Y)]);
        parts = [.. scene.Models.SelectMany(PartsOf)];
        right = Run(program, null);
        arithmetic.Keeps = false;
    }

    /// <summary>The values of the names that every scene gives, each at its symbol's place.</summary>
    public static Batch[] GivensOf(Camera camera)
    {
        var givens = new Batch[Symbol.Max];
        Give("P", Batch.Of(camera.Position));
        Give("T", Batch.Of(camera.Target));
        Give("up", Batch.Of(camera.Up));
        Give("fovY", Batch.Of(camera.FovY));
        Give("width", Batch.Of(camera.Width));
        Give("height", Batch.Of(camera.Height));
        Give("zNear", Batch.Of(camera.ZNear));
        Give("zFar", Batch.Of(Math.Min(camera.ZFar, double.MaxValue))); // so that the infinite t of a parallel ray never counts
        Give("bias", Batch.Of(camera.Bias == 0 ? -double.Epsilon : camera.Bias)); // with a bias of 0, t = 0 counts
        Give("π", Batch.Of(Math.PI));
        return givens;

        void Give(string name, Batch value) => givens[Symbol.Of(name).Place] = value;
    }

    /// <summary>The bytes of all pixels: red, green, blue, and so on.</summary>
    public byte[] Draw(FormulaProgram program)
    {
        arithmetic.Forget();
        return ReferenceEquals(program, right.Program) ? right.Bytes : Run(program, right).Bytes;
    }

    /// <summary>The bytes of the program that others are edits of.</summary>
    public byte[] Right => right.Bytes;

    private State Run(FormulaProgram program, State? basis)
    {
        arithmetic.Functions = program[SectionKind.Vectors];
        var changed = basis is null ? 0 : ChangedFunctions(basis.Program[SectionKind.Vectors], arithmetic.Functions);
        var frame = (Batch[])givens.Clone();
        foreach (var kind in (ReadOnlySpan<SectionKind>)[SectionKind.Camera, SectionKind.File, SectionKind.Pixel])
            Define(program[kind], frame, basis?.Program[kind], basis?.Frame, ref changed);

        var rule = program[SectionKind.Rule];
        var sameRule = IsSame(SectionKind.Rule);
        var hits = new double[parts.Length][];
        var areNew = false;
        for (var i = 0; i < parts.Length; i++)
        {
            var isSame = sameRule && (parts[i].Kind is { } kind ? IsSame(kind) : (changed & ray) == 0);
            areNew |= !isSame;
            hits[i] = isSame ? basis!.Hits[i]
                : parts[i].Kind is { } shape ? HitsOf(i, program[shape], rule, frame, changed, basis)
                : HitsOf(parts[i].Model, rule, frame);
        }
        var (nearest, t) = areNew || basis is null ? Nearest(hits) : (basis.Nearest, basis.T);
        if (!areNew && IsSame(SectionKind.Light) && IsSame(SectionKind.Bytes)) return basis!;
        return new(program, frame, hits, nearest, t, BytesOf(program, frame, nearest, t));

        bool IsSame(SectionKind kind) =>
            basis is not null && ReferenceEquals(program[kind], basis.Program[kind]) && (program[kind].Reads & changed) == 0;
    }

    private static readonly UInt128 ray = Symbol.Of("P").Bit | Symbol.Of("d").Bit;

    /// <summary>The functions whose values an edit changes, also through another function.</summary>
    private static UInt128 ChangedFunctions(FormulaSection before, FormulaSection now)
    {
        UInt128 changed = 0;
        if (ReferenceEquals(before, now)) return changed;
        for (var i = 0; i < now.Formulas.Length; i++)
        {
            var formula = now.Formulas[i];
            if (!ReferenceEquals(formula.Right, before.Formulas[i].Right) || (formula.Right.Reads & changed) != 0) changed |= formula.Name.Bit;
        }
        return changed;
    }

    /// <summary>Computes a section's formulas, or takes their values from another frame where nothing that they read has changed.</summary>
    private void Define(FormulaSection section, Batch[] frame, FormulaSection? before, Batch[]? old, ref UInt128 changed)
    {
        for (var i = 0; i < section.Formulas.Length; i++)
        {
            var (name, expression, _) = section.Formulas[i];
            var known = before is not null && i < before.Formulas.Length && before.Formulas[i].Name == name ? before.Formulas[i] : null;
            if (known is not null && ReferenceEquals(known.Right, expression) && (expression.Reads & changed) == 0)
            {
                frame[name.Place] = old![name.Place];
                changed &= ~name.Bit;
                continue;
            }
            var value = arithmetic.Evaluate(expression, frame);
            if (known is not null && value.IsSameAs(old![name.Place])) changed &= ~name.Bit;
            else changed |= name.Bit;
            frame[name.Place] = value;
        }
    }

    /// <summary>The first crossing of a shape that counts, in each pixel; NaN for none.</summary>
    private double[] HitsOf(int part, FormulaSection section, FormulaSection rule, Batch[] camera, UInt128 changed, State? basis)
    {
        var before = basis is null ? null : StyleOf(section, basis.Program);
        var old = before is null ? null : RightFrame(part, before, basis!.Frame);
        var frame = FrameOf(part, camera, ofShape);
        foreach (var (symbol, _) in parts[part].Numbers) changed &= ~symbol.Bit;
        Define(section, frame, before, old, ref changed);

        var hits = arithmetic.New(count);
        Array.Fill(hits, double.NaN);
        var when = !section.Has(Formula.When) ? Batch.Of(1) : frame[Formula.When.Place];
        foreach (var crossing in (ReadOnlySpan<Symbol>)[Formula.Near, Formula.Far])
        {
            if (!section.Has(crossing)) continue;
            var (t, counts) = Counted(frame[crossing.Place], rule, camera);
            for (var i = 0; i < count; i++)
                if (double.IsNaN(hits[i]) && counts[i] != 0 && when[i] != 0) hits[i] = t[i];
        }
        return hits;
    }

    /// <summary>The unedited section in the same style.</summary>
    private static FormulaSection StyleOf(FormulaSection section, FormulaProgram program) =>
        program[section.Kind].Style == section.Style ? program[section.Kind] : FormulaBook.Slides[section.Kind, section.Style];

    /// <summary>A shape's frame in a style, as the program that others are edits of has it.</summary>
    private Batch[] RightFrame(int part, FormulaSection section, Batch[] camera)
    {
        if (rightFrames.TryGetValue((part, section), out var frame)) return frame;
        var keeps = arithmetic.Keeps;
        var functions = arithmetic.Functions;
        arithmetic.Keeps = true;
        arithmetic.Functions = right.Program[SectionKind.Vectors];
        frame = FrameOf(part, camera, new Batch[Symbol.Max]);
        UInt128 changed = 0;
        Define(section, frame, null, null, ref changed);
        arithmetic.Keeps = keeps;
        arithmetic.Functions = functions;
        return rightFrames[(part, section)] = frame;
    }

    private Batch[] FrameOf(int part, Batch[] camera, Batch[] into)
    {
        var frame = Copied(camera, into);
        foreach (var (symbol, value) in parts[part].Numbers) frame[symbol.Place] = value;
        return frame;
    }

    private static Batch[] Copied(Batch[] frame, Batch[] into)
    {
        frame.CopyTo(into, 0);
        return into;
    }

    /// <summary>A crossing's t as the rule has it, and whether it counts.</summary>
    private (Batch T, Batch Counts) Counted(Batch crossing, FormulaSection rule, Batch[] camera)
    {
        var frame = Copied(camera, ofRule);
        frame[Symbol.Of("t").Place] = crossing;
        UInt128 changed = 0;
        Define(rule, frame, null, null, ref changed);
        return (frame[Formula.Near.Place], !rule.Has(Formula.When) ? Batch.Of(1) : frame[Formula.When.Place]);
    }

    /// <summary>The same for a model that has no section: a large mesh, a shape of one's own.</summary>
    private double[] HitsOf(Model model, FormulaSection rule, Batch[] camera)
    {
        var hits = arithmetic.New(count);
        for (var i = 0; i < count; i++)
        {
            var origin = camera[Symbol.Of("P").Place].At(i);
            var d = camera[Symbol.Of("d").Place].At(i);
            hits[i] = double.IsNaN(d.X + d.Y + d.Z) ? double.NaN
                : model is Mesh mesh ? mesh.Tree.Nearest(origin, d, triangle => Counts(mesh[triangle].Intersect(new Ray<Scalar>(origin, d)).Near, i))
                    ?? double.NaN
                : model.Intersect(new Ray(origin, d) { ClipRange = scene.Camera.ClipRange, DepthPerT = scene.Camera.DepthPerT<Scalar>(d) })
                    ?? double.NaN;
        }
        return hits;

        double? Counts(double t, int pixel)
        {
            if (double.IsNaN(t)) return null;
            var only = (Batch[])camera.Clone();
            only[Symbol.Of("d").Place] = Batch.Of(camera[Symbol.Of("d").Place].At(pixel));
            var counted = Counted(Batch.Of(t), rule, only);
            return counted.Counts[0] != 0 ? counted.T[0] : null;
        }
    }

    private (int[] Nearest, double[] T) Nearest(double[][] hits)
    {
        var nearest = new int[count];
        var t = arithmetic.New(count);
        for (var i = 0; i < count; i++)
        {
            (nearest[i], t[i]) = (-1, double.PositiveInfinity);
            for (var k = 0; k < hits.Length; k++)
                if (hits[k][i] < t[i]) (nearest[i], t[i]) = (k, hits[k][i]);
        }
        return (nearest, t);
    }

    private byte[] BytesOf(FormulaProgram program, Batch[] camera, int[] nearest, double[] t)
    {
        var frame = Copied(camera, ofRule);
        var own = arithmetic.NewVector(count);
        var seen = arithmetic.NewVector(count);
        for (var i = 0; i < count; i++) own.Set(i, ColorOf(nearest[i]));
        frame[Symbol.Of("t").Place] = new(t);
        frame[Symbol.Of("K").Place] = own;
        UInt128 changed = 0;
        Define(program[SectionKind.Light], frame, null, null, ref changed);
        var lit = frame[Symbol.Of("colour").Place];
        for (var i = 0; i < count; i++) seen.Set(i, nearest[i] < 0 ? own.At(i) : lit.At(i)); // the background does not fade
        frame[Symbol.Of("colour").Place] = seen;
        Define(program[SectionKind.Bytes], frame, null, null, ref changed);
        var rgb = frame[Symbol.Of("rgb").Place];
        var bytes = new byte[3 * shown];
        for (var i = 0; i < shown; i++)
        {
            var (r, g, b) = rgb.At(i);
            (bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]) = ((byte)r, (byte)g, (byte)b);
        }
        return bytes;

        Vector3 ColorOf(int part)
        {
            var (r, g, b) = part < 0 ? scene.Background : parts[part].Model.Color;
            return new(r, g, b);
        }
    }

    /// <summary>The step whose formulas cross a model; null for a shape of one's own.</summary>
    public static SectionKind? KindOf(Model model) => PartsOf(model).First().Kind;

    /// <summary>A model with the numbers that its section reads; a small mesh is its triangles.</summary>
    private static IEnumerable<Part> PartsOf(Model model) => model switch
    {
        Model<Plane> { Primitive: var plane } => [new(model, SectionKind.Plane, NumbersOf(plane))],
        Model<Sphere> { Primitive: var sphere } => [new(model, SectionKind.Sphere, NumbersOf(sphere))],
        Model<Circle> { Primitive: var circle } => [new(model, SectionKind.Circle, NumbersOf(circle))],
        Model<Aabb> { Primitive: var box } => [new(model, SectionKind.Aabb, NumbersOf(box))],
        Model<Triangle> { Primitive: var triangle } => [new(model, SectionKind.Triangle, NumbersOf(triangle))],
        Mesh { TriangleCount: > 0 and <= MaxTriangles } mesh =>
            Enumerable.Range(0, mesh.TriangleCount).Select(i => new Part(mesh, SectionKind.Triangle, NumbersOf(mesh[i]))),
        _ => [new(model, null, [])],
    };

    private static readonly Symbol Q = Symbol.Of("Q"), n = Symbol.Of("n"), C = Symbol.Of("C"), R = Symbol.Of("R"), B0 = Symbol.Of("B0"),
        B1 = Symbol.Of("B1"), A = Symbol.Of("A"), B = Symbol.Of("B");

    public static (Symbol Name, Batch Value)[] NumbersOf(Plane plane) => [(Q, Batch.Of(plane.Point)), (n, Batch.Of(plane.Normal))];

    public static (Symbol Name, Batch Value)[] NumbersOf(Sphere sphere) => [(C, Batch.Of(sphere.Center)), (R, Batch.Of(sphere.Radius))];

    public static (Symbol Name, Batch Value)[] NumbersOf(Circle circle) =>
        [(C, Batch.Of(circle.Center)), (n, Batch.Of(circle.Normal)), (R, Batch.Of(circle.Radius))];

    public static (Symbol Name, Batch Value)[] NumbersOf(Aabb box) => [(B0, Batch.Of(box.Min)), (B1, Batch.Of(box.Max))];

    public static (Symbol Name, Batch Value)[] NumbersOf(Triangle triangle) =>
        [(A, Batch.Of(triangle.A)), (B, Batch.Of(triangle.B)), (C, Batch.Of(triangle.C))];

    private sealed record Part(Model Model, SectionKind? Kind, (Symbol Name, Batch Value)[] Numbers);

    /// <param name="Frame">What camera and pixel have computed.</param>
    /// <param name="Hits">For each part the t of its hit in each pixel.</param>
    /// <param name="Nearest">The part that each pixel shows; −1 for none.</param>
    private sealed record State(FormulaProgram Program, Batch[] Frame, double[][] Hits, int[] Nearest, double[] T, byte[] Bytes);
}
