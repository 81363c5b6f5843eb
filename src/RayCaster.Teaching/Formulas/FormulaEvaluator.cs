using System.Numerics;

namespace RayCaster.Teaching.Formulas;

/// <summary>Draws pixels of a scene as programs do. Of a program that differs from the first one, it computes only what the difference reaches.
/// </summary>
/// <remarks>Not for several threads.</remarks>
internal sealed class FormulaEvaluator
{
    /// <summary>A mesh with more triangles is searched through its tree.</summary>
    public const int MaxTriangles = 100;

    /// <summary>How many pixels are computed together, at most: their numbers stay in the processor's cache.</summary>
    private const int MaxTogether = 1024;

    /// <summary>What a ray through a mesh's tree, or to a shape of one's own, takes, as so many computed numbers do.</summary>
    private const int WorkOfRay = 200;

    private static readonly UInt128 ofRay = Symbol.Of("P").Bit | Symbol.Of("d").Bit;

    private readonly Scene scene;
    private readonly int count; // pixels of a group: those that are drawn, and with the last one again and again as many as the arithmetic needs
    private readonly PixelArithmetic arithmetic;
    private readonly PixelValues[] givens;
    private readonly Part[] parts;
    private readonly Group[] groups;
    private readonly Dictionary<(int Part, Step Section), PixelValues[]>? rightFrames; // null for many pixels: they would take much memory

    // used again and again
    private readonly PixelValues[] ofPixel = new PixelValues[Symbol.Max];
    private readonly PixelValues[] ofShape = new PixelValues[Symbol.Max];
    private readonly PixelValues[] ofRule = new PixelValues[Symbol.Max];
    private readonly FormulaProgram? right;

    /// <param name="pixels">Columns from the left and lines from the top of the file.</param>
    /// <param name="program">The program that others differ from.</param>
    public FormulaEvaluator(Scene scene, IReadOnlyList<(int X, int Y)> pixels, FormulaProgram program)
        : this(scene, pixels)
    {
        right = program;
        if (groups.Length == 1) rightFrames = [];
        foreach (var group in groups) group.Right = Run(program, group).Copy();
    }

    private FormulaEvaluator(Scene scene, IReadOnlyList<(int X, int Y)> pixels)
    {
        this.scene = scene;
        var number = Math.Max(1, (pixels.Count + MaxTogether - 1) / MaxTogether);
        var shown = (pixels.Count + number - 1) / number;
        count = (shown + Vector<double>.Count - 1) / Vector<double>.Count * Vector<double>.Count;
        groups = [.. Enumerable.Range(0, number).Select(i => new Group([.. pixels.Skip(i * shown).Take(shown)], count))];
        arithmetic = new(count);
        givens = GivensOf(scene.Camera);
        parts = [.. scene.Models.SelectMany(PartsOf)];
    }

    /// <summary>The values of the names that every scene gives, each at its symbol's place.</summary>
    private static PixelValues[] GivensOf(Camera camera)
    {
        var givens = new PixelValues[Symbol.Max];
        Give("P", PixelValues.Of(camera.Position));
        Give("T", PixelValues.Of(camera.Target));
        Give("up", PixelValues.Of(camera.Up));
        Give("fovY", PixelValues.Of(camera.FovY));
        Give("width", PixelValues.Of(camera.Width));
        Give("height", PixelValues.Of(camera.Height));
        Give("zNear", PixelValues.Of(camera.ZNear));
        Give("zFar", PixelValues.Of(Math.Min(camera.ZFar, double.MaxValue))); // so that the infinite t of a parallel ray never counts
        Give("bias", PixelValues.Of(camera.Bias == 0 ? -double.Epsilon : camera.Bias)); // with a bias of 0, t = 0 counts
        Give("∞", PixelValues.Of(double.PositiveInfinity));
        Give("π", PixelValues.Of(Math.PI));
        return givens;

        void Give(string name, PixelValues value) => givens[Symbol.Of(name).Place] = value;
    }

    /// <summary>What a program draws in some pixels, of which there may be many: red, green, blue, and so on.</summary>
    /// <param name="pixels">Columns from the left and lines from the top of the program's file.</param>
    /// <param name="budget">What is spent; null if it is not counted.</param>
    public static byte[] Draw(Scene scene, FormulaProgram program, IReadOnlyList<(int X, int Y)> pixels, SearchBudget? budget = null) =>
        program.MovedBytes != 0 ? DrawMoved(scene, program, pixels, budget) : new FormulaEvaluator(scene, pixels).Draw(program, budget);

    /// <summary>The same where a byte comes from another place in the file; what is before the first or after the last one is a line break.
    /// </summary>
    private static byte[] DrawMoved(Scene scene, FormulaProgram program, IReadOnlyList<(int X, int Y)> pixels, SearchBudget? budget)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        if (program.IsTurned) (width, height) = (height, width);
        int[] sources = [.. from pixel in pixels from channel in (int[])[0, 1, 2]
            select 3 * (pixel.Y * width + pixel.X) + channel - program.MovedBytes];
        int[] places = [.. sources.Where(IsInFile).Select(source => source / 3).Distinct()];
        var drawn = Draw(scene, program with { MovedBytes = 0 }, [.. places.Select(place => (place % width, place / width))], budget);
        var at = places.Index().ToDictionary(place => place.Item, place => 3 * place.Index);
        return [.. sources.Select(source => IsInFile(source) ? drawn[at[source / 3] + source % 3] : (byte)'\n')];

        bool IsInFile(int source) => source >= 0 && source < 3 * width * height;
    }

    /// <summary>The bytes of all pixels: red, green, blue, and so on.</summary>
    /// <param name="budget">What is spent; null if it is not counted.</param>
    public byte[] Draw(FormulaProgram program, SearchBudget? budget = null)
    {
        var rgb = new byte[3 * groups.Sum(group => group.Shown)];
        var drawn = 0;
        arithmetic.Work = 0;
        foreach (var group in groups)
        {
            var bytes = ReferenceEquals(program, right) ? group.Right!.Bytes : Run(program, group).Bytes;
            bytes.CopyTo(rgb, drawn);
            drawn += bytes.Length;
        }
        budget?.Spend(arithmetic.Work);
        return rgb;
    }

    /// <returns>What the next run overwrites.</returns>
    private State Run(FormulaProgram program, Group group)
    {
        var basis = group.Right;
        (givens[Symbol.Of("x").Place], givens[Symbol.Of("y").Place]) = (group.X, group.Y);
        arithmetic.GiveBack(0);
        arithmetic.Functions = program[StepKind.Vectors];
        var changed = basis is null ? 0 : ChangedFunctions(basis.Program[StepKind.Vectors], arithmetic.Functions);
        var frame = Copied(givens, ofPixel);
        if (program.SwapsEnds)
            (frame[pointP.Place], frame[pointT.Place]) = (frame[pointT.Place], frame[pointP.Place]);
        if (basis is not null && basis.Program.SwapsEnds != program.SwapsEnds) changed |= pointP.Bit | pointT.Bit;
        foreach (var kind in (ReadOnlySpan<StepKind>)[StepKind.Camera, StepKind.File, StepKind.Sample, StepKind.Pixel])
            Define(program[kind], frame, basis?.Program[kind], basis?.Frame, ref changed);

        var loop = program[StepKind.Nearest];
        var isUsual = loop == FormulaBook.Slides.StylesOf(StepKind.Nearest)[0];
        var sameLoop = basis is not null && loop == basis.Program[StepKind.Nearest];
        var areNew = !sameLoop || !program.LeftOut.SetEquals(basis!.Program.LeftOut) || program.Scatters != basis.Program.Scatters;
        var crossed = new Crossed[parts.Length];
        for (var i = 0; i < parts.Length; i++)
        {
            var part = parts[i];
            var rule = program.RuleOf(part.Kind);
            var isSame = sameLoop && ReferenceEquals(rule, basis!.Program.RuleOf(part.Kind)) && (rule.Reads & changed) == 0
                && (part.Kind is { } kind ? IsSame(kind) : (changed & ofRay) == 0)
                && (!part.IsLarge || basis.Program[StepKind.Vectors] == program[StepKind.Vectors]);
            areNew |= !isSame;
            crossed[i] = isSame ? basis!.Hits[i] : CrossingsOf(i, program, rule, frame, changed, basis, !isUsual);
        }
        var (nearest, t) = areNew ? Nearest(program, crossed, frame, isUsual) : (basis!.Nearest, basis.T);
        if (!areNew && IsSame(StepKind.Light) && IsSame(StepKind.Bytes) && (Formula.Written.Bit & changed) == 0
            && program[StepKind.File].Has(Formula.Written) == basis!.Program[StepKind.File].Has(Formula.Written)) return basis;
        return new(program, frame, crossed, nearest, t, BytesOf(program, frame, nearest, t, group.Shown));

        bool IsSame(StepKind kind) =>
            basis is not null && ReferenceEquals(program[kind], basis.Program[kind]) && (program[kind].Reads & changed) == 0;
    }

    private static readonly Symbol pointP = Symbol.Of("P"), pointT = Symbol.Of("T"), direction = Symbol.Of("d"), parameter = Symbol.Of("t"),
        best = Symbol.Of("best"), axisW = Symbol.Of("W");

    /// <summary>The functions whose values an edit changes, also through another function.</summary>
    private static UInt128 ChangedFunctions(Step before, Step now)
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
    private void Define(Step section, PixelValues[] frame, Step? before, PixelValues[]? old, ref UInt128 changed)
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

    /// <summary>Computes a section's formulas.</summary>
    private void Define(Step section, PixelValues[] frame)
    {
        foreach (var (name, expression, _) in section.Formulas) frame[name.Place] = arithmetic.Evaluate(expression, frame);
    }

    private Crossed CrossingsOf(int part, FormulaProgram program, Step rule, PixelValues[] camera, UInt128 changed, State? basis, bool withAll)
    {
        var (model, kind, numbers) = parts[part];
        if (kind is null || (parts[part].IsLarge && !AreTrianglesMutated(program))) return HitsOf(model, rule, camera);
        var used = arithmetic.Used;
        var section = program[kind.Value];
        if (parts[part].IsLarge)
            return program.ProposesTriangles ? Decided(ProposedBy((Mesh)model, camera)) : OfAll((Mesh)model);

        var before = basis is null || rightFrames is null ? null : StyleOf(section, basis.Program);
        var old = before is null ? null : RightFrame(part, before, basis!.Frame);
        var frame = FrameOf(numbers, camera, ofShape);
        foreach (var (symbol, _) in numbers) changed &= ~symbol.Bit;
        Define(section, frame, before, old, ref changed);
        var crossed = Counted(section, rule, frame, camera, withAll);
        arithmetic.GiveBack(used, crossed.T, crossed.IsHit, crossed.Far, crossed.Ends?.X);
        return crossed;

        Crossed Decided((Symbol, PixelValues)[] triangles)
        {
            var own = FrameOf(triangles, camera, ofShape);
            Define(section, own);
            return Counted(section, rule, own, camera, withAll);
        }

        // Each triangle is offered to the nearest one of the mesh so far.
        Crossed OfAll(Mesh mesh)
        {
            var nearest = arithmetic.New(count);
            Array.Fill(nearest, double.NaN);
            var ends = arithmetic.New(count);
            Array.Clear(ends);
            var before = arithmetic.Used;
            for (var k = 0; k < mesh.TriangleCount; k++)
            {
                var of = Decided(NumbersOf(mesh[k]));
                Offer(nearest, of.T);
                for (var i = 0; of.Ends is { } own && i < count; i++) ends[i] = Math.Max(ends[i], own[i]);
                arithmetic.GiveBack(before);
            }
            return new(nearest) { Ends = rule.Has(Formula.Ends) ? new(ends) : null };
        }
    }

    /// <summary>Whether a program computes the hits of triangles by other formulas than the slides'.</summary>
    public static bool AreTrianglesMutated(FormulaProgram program)
    {
        var slides = FormulaBook.Slides;
        var section = program[StepKind.Triangle];
        return !slides.StylesOf(StepKind.Triangle).Contains(section)
            || (section.Reads & ChangedFunctions(slides.StylesOf(StepKind.Vectors)[0], program[StepKind.Vectors])) != 0;
    }

    /// <summary>The first crossing of a shape that counts, in each pixel.</summary>
    /// <param name="frame">What the shape's formulas have computed.</param>
    /// <param name="withAll">Whether a t that is no number may be a hit, and the second crossing is needed, too.</param>
    private Crossed Counted(Step section, Step rule, PixelValues[] frame, PixelValues[] camera, bool withAll)
    {
        var one = PixelValues.Of(1);
        var when = section.Has(Formula.When) ? frame[Formula.When.Place] : one;
        var first = ByRule(frame[Formula.Near.Place], rule, camera);
        var second = section.Has(Formula.Far) ? ByRule(frame[Formula.Far.Place], rule, camera) : default;
        var t = arithmetic.New(count);
        var isHit = withAll ? arithmetic.New(count) : null;
        for (var i = 0; i < count; i++)
        {
            var isFirst = first.Counts[i] != 0;
            var isSecond = !isFirst && second.T.X is not null && second.Counts[i] != 0 && (first.Second is not { } tried || tried[i] != 0);
            t[i] = when[i] == 0 || !(isFirst || isSecond) ? double.NaN : isFirst ? first.T[i] : second.T[i];
            if (isHit is not null) isHit[i] = when[i] != 0 && (isFirst || isSecond) ? 1 : 0;
        }
        PixelValues? ends = null;
        if (first.Ends is { } all)
        {
            var own = arithmetic.New(count);
            for (var i = 0; i < count; i++) own[i] = when[i] != 0 && double.IsFinite(first.T[i]) ? all[i] : 0;
            ends = new(own);
        }
        double[]? far = null;
        if (withAll && second.T.X is not null)
        {
            far = arithmetic.New(count);
            for (var i = 0; i < count; i++) far[i] = when[i] != 0 && second.Counts[i] != 0 && second.T[i] > t[i] ? second.T[i] : double.NaN;
        }
        return new(t) { IsHit = isHit, Far = far, Ends = ends };
    }

    /// <summary>A crossing's t as the rule has it, and whether it counts.</summary>
    private (PixelValues T, PixelValues Counts, PixelValues? Ends, PixelValues? Second) ByRule(PixelValues crossing, Step rule, PixelValues[] camera)
    {
        var frame = Copied(camera, ofRule);
        frame[parameter.Place] = crossing;
        Define(rule, frame);
        var counts = rule.Has(Formula.When) ? frame[Formula.When.Place] : PixelValues.Of(1);
        return (frame[Formula.Near.Place], counts, Of(Formula.Ends), Of(Formula.Second));

        PixelValues? Of(Symbol name) => rule.Has(name) ? frame[name.Place] : null;
    }

    /// <summary>Puts in each pixel the lesser of two t, of which NaN is none.</summary>
    private static void Offer(double[] nearest, double[] t)
    {
        for (var i = 0; i < t.Length; i++)
            if (!(nearest[i] <= t[i])) nearest[i] = double.IsNaN(t[i]) ? nearest[i] : t[i];
    }

    /// <summary>The unedited section in the same style.</summary>
    private static Step StyleOf(Step section, FormulaProgram program) =>
        program[section.Kind].Style == section.Style ? program[section.Kind] : FormulaBook.Slides[section.Kind, section.Style];

    /// <summary>A shape's frame in a style, as the program that others differ from has it.</summary>
    private PixelValues[] RightFrame(int part, Step section, PixelValues[] camera)
    {
        if (rightFrames!.TryGetValue((part, section), out var frame)) return frame;
        var (functions, used, work) = (arithmetic.Functions, arithmetic.Used, arithmetic.Work);
        arithmetic.Functions = right![StepKind.Vectors];
        frame = FrameOf(parts[part].Numbers, camera, new PixelValues[Symbol.Max]);
        Define(section, frame);
        foreach (var formula in section.Formulas) frame[formula.Name.Place] = frame[formula.Name.Place].Copy();
        arithmetic.Functions = functions;
        arithmetic.GiveBack(used);
        arithmetic.Work = work; // which thread needs the frame first must not matter
        return rightFrames[(part, section)] = frame;
    }

    private static PixelValues[] FrameOf((Symbol Name, PixelValues Value)[] numbers, PixelValues[] camera, PixelValues[] into)
    {
        var frame = Copied(camera, into);
        foreach (var (symbol, value) in numbers) frame[symbol.Place] = value;
        return frame;
    }

    private static PixelValues[] Copied(PixelValues[] frame, PixelValues[] into)
    {
        frame.CopyTo(into, 0);
        return into;
    }

    /// <summary>For each pixel the triangle of a mesh that the definition hits first; corners of NaN where it hits none.</summary>
    private (Symbol Name, PixelValues Value)[] ProposedBy(Mesh mesh, PixelValues[] camera)
    {
        var corners = (A: arithmetic.NewVector(count), B: arithmetic.NewVector(count), C: arithmetic.NewVector(count));
        var none = new Vector3(double.NaN, double.NaN, double.NaN);
        arithmetic.Work += WorkOfRay * count;
        for (var i = 0; i < count; i++)
        {
            var origin = camera[pointP.Place].At(i);
            var d = camera[direction.Place].At(i);
            var (nearest, least) = (-1, double.PositiveInfinity);
            if (!double.IsNaN(d.X + d.Y + d.Z))
                mesh.Tree.Nearest(origin, d, triangle =>
                {
                    var t = (double)mesh[triangle].Intersect(new Ray<Scalar>(origin, d)).Near;
                    if (!(t > scene.Camera.Bias)) return null;
                    if (t < least) (nearest, least) = (triangle, t);
                    return t;
                });
            var (a, b, c) = nearest < 0 ? (none, none, none) : (mesh[nearest].A, mesh[nearest].B, mesh[nearest].C);
            corners.A.Set(i, a);
            corners.B.Set(i, b);
            corners.C.Set(i, c);
        }
        return [(A, corners.A), (B, corners.B), (C, corners.C)];
    }

    /// <summary>The hits of a model whose own formulas are the definition's: a large mesh, a shape of one's own.</summary>
    private Crossed HitsOf(Model model, Step rule, PixelValues[] camera)
    {
        var isUsual = FormulaBook.Slides.StylesOf(StepKind.Rule).Contains(rule) && rule.Style != "aim";
        var hits = arithmetic.New(count);
        arithmetic.Work += WorkOfRay * count;
        for (var i = 0; i < count; i++)
        {
            var origin = camera[pointP.Place].At(i);
            var d = camera[direction.Place].At(i);
            if (double.IsNaN(d.X + d.Y + d.Z))
            {
                hits[i] = double.NaN;
                continue;
            }
            var ray = new Ray(origin, d)
            {
                ClipRange = scene.Camera.ClipRange,
                DepthPerT = scene.Camera.Clip == ClipMode.Depth ? -(d * camera[axisW.Place].At(i)) : 1,
            };
            hits[i] = (model is not Mesh mesh ? model.Intersect(ray) : mesh.Tree.Nearest(origin, d, triangle =>
            {
                var t = (double)mesh[triangle].Intersect(new Ray<Scalar>(origin, d)).Near;
                return !isUsual ? Counts(t, i) : ray.Counts(t) ? t : null;
            })) ?? double.NaN;
        }
        return new(hits);

        double? Counts(double t, int pixel)
        {
            if (double.IsNaN(t)) return null;
            var only = (PixelValues[])camera.Clone();
            only[direction.Place] = PixelValues.Of(camera[direction.Place].At(pixel));
            var (own, counts, _, _) = ByRule(PixelValues.Of(t), rule, only);
            return counts[0] != 0 ? own[0] : null;
        }
    }

    /// <summary>Which part each pixel shows, −1 for none, and at which t.</summary>
    private (int[] Part, double[] T) Nearest(FormulaProgram program, Crossed[] crossed, PixelValues[] camera, bool isUsual)
    {
        int[] drawn = [.. Enumerable.Range(0, parts.Length).Where(k => !program.LeftOut.Contains(parts[k].Model.Kind)
            && !(program.Scatters && parts[k].Kind == StepKind.Triangle))];
        var nearest = new int[count];
        Array.Fill(nearest, -1);
        var t = arithmetic.New(count);
        Array.Fill(t, double.PositiveInfinity);
        if (isUsual)
        {
            foreach (var k in drawn)
            {
                var hits = crossed[k].T;
                for (var i = 0; i < count; i++)
                    if (hits[i] < t[i]) (nearest[i], t[i]) = (k, hits[i]);
            }
        }
        else Choose(program[StepKind.Nearest], drawn, crossed, camera, nearest, t);
        foreach (var k in drawn)
        {
            if (crossed[k].Ends is not { } ends) continue;
            for (var i = 0; i < count; i++)
                if (ends[i] != 0) nearest[i] = -1;
        }
        return (nearest, t);
    }

    /// <summary>Chooses by the formulas of the loop. The triangles of a mesh are one model, which has one hit.</summary>
    private void Choose(Step loop, int[] drawn, Crossed[] crossed, PixelValues[] camera, int[] nearest, double[] shownT)
    {
        var frame = FrameOf([(parameter, new(shownT)), (best, new(shownT))], camera, new PixelValues[Symbol.Max]);
        Define(loop, frame);
        var start = frame[Symbol.Of("start").Place];
        var offersBoth = frame[Symbol.Of("both").Place][0] != 0;
        var least = arithmetic.New(count);
        for (var i = 0; i < count; i++) (least[i], shownT[i]) = (start[i], double.NaN);
        frame[best.Place] = new(least);
        for (var k = 0; k < drawn.Length; k++)
        {
            var first = k;
            var hits = crossed[drawn[k]].T;
            if (parts[drawn[k]].Model is Mesh mesh)
            {
                hits = (double[])hits.Clone();
                for (; k + 1 < drawn.Length && parts[drawn[k + 1]].Model == mesh; k++) Offer(hits, crossed[drawn[k + 1]].T);
            }
            OfferAll(drawn[first], hits, crossed[drawn[first]].IsHit);
            if (offersBoth && crossed[drawn[first]].Far is { } far) OfferAll(drawn[first], far, null);
        }
        (frame[parameter.Place], frame[best.Place]) = (new(shownT), new(least));
        Define(loop, frame);
        var kept = frame[Symbol.Of("kept").Place];
        for (var i = 0; i < count; i++)
            if (kept[i] == 0) nearest[i] = -1;

        void OfferAll(int part, double[] t, double[]? isHit)
        {
            frame[parameter.Place] = new(t);
            var used = arithmetic.Used;
            Define(loop, frame);
            var (better, replaces, lights) =
                (frame[Symbol.Of("better").Place], frame[Symbol.Of("replaces").Place], frame[Symbol.Of("lights").Place]);
            for (var i = 0; i < count; i++)
            {
                if (isHit is null ? double.IsNaN(t[i]) : isHit[i] == 0) continue;
                if (better[i] != 0) nearest[i] = part;
                if (lights[i] != 0) shownT[i] = t[i];
                if (replaces[i] != 0) least[i] = t[i];
            }
            arithmetic.GiveBack(used);
        }
    }

    private byte[] BytesOf(FormulaProgram program, PixelValues[] camera, int[] nearest, double[] t, int shown)
    {
        var frame = Copied(camera, ofRule);
        var own = arithmetic.NewVector(count);
        var seen = arithmetic.NewVector(count);
        for (var i = 0; i < count; i++) own.Set(i, ColorOf(nearest[i]));
        frame[parameter.Place] = new(t);
        frame[Symbol.Of("K").Place] = own;
        Define(program[StepKind.Light], frame);
        var lit = frame[Symbol.Of("colour").Place];
        for (var i = 0; i < count; i++) seen.Set(i, nearest[i] < 0 ? own.At(i) : lit.At(i)); // the background does not fade
        frame[Symbol.Of("colour").Place] = seen;
        Define(program[StepKind.Bytes], frame);
        var rgb = frame[Symbol.Of("rgb").Place];
        var isWritten = program[StepKind.File].Has(Formula.Written) ? camera[Formula.Written.Place] : PixelValues.Of(1);
        var bytes = new byte[3 * shown];
        for (var i = 0; i < shown; i++)
        {
            if (isWritten[i] == 0) continue;
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

    /// <summary>The step whose formulas cross a model; null for a shape of one's own, and for a mesh without triangles.</summary>
    public static StepKind? KindOf(Model model) => PartsOf(model).First().Kind;

    /// <summary>A model with the numbers that its section reads; a small mesh is its triangles.</summary>
    private static IEnumerable<Part> PartsOf(Model model) => model switch
    {
        Model<Plane> { Primitive: var plane } => [new(model, StepKind.Plane, NumbersOf(plane))],
        Model<Sphere> { Primitive: var sphere } => [new(model, StepKind.Sphere, NumbersOf(sphere))],
        Model<Circle> { Primitive: var circle } => [new(model, StepKind.Circle, NumbersOf(circle))],
        Model<Aabb> { Primitive: var box } => [new(model, StepKind.Aabb, NumbersOf(box))],
        Model<Triangle> { Primitive: var triangle } => [new(model, StepKind.Triangle, NumbersOf(triangle))],
        Mesh { TriangleCount: > 0 and <= MaxTriangles } mesh =>
            Enumerable.Range(0, mesh.TriangleCount).Select(i => new Part(mesh, StepKind.Triangle, NumbersOf(mesh[i]))),
        Mesh { TriangleCount: > MaxTriangles } mesh => [new(mesh, StepKind.Triangle, []) { IsLarge = true }],
        _ => [new(model, null, [])],
    };

    private static readonly Symbol Q = Symbol.Of("Q"), n = Symbol.Of("n"), C = Symbol.Of("C"), R = Symbol.Of("R"), B0 = Symbol.Of("B0"),
        B1 = Symbol.Of("B1"), A = Symbol.Of("A"), B = Symbol.Of("B");

    private static (Symbol Name, PixelValues Value)[] NumbersOf(Plane plane) =>
        [(Q, PixelValues.Of(plane.Point)), (n, PixelValues.Of(plane.Normal))];

    private static (Symbol Name, PixelValues Value)[] NumbersOf(Sphere sphere) =>
        [(C, PixelValues.Of(sphere.Center)), (R, PixelValues.Of(sphere.Radius))];

    private static (Symbol Name, PixelValues Value)[] NumbersOf(Circle circle) =>
        [(C, PixelValues.Of(circle.Center)), (n, PixelValues.Of(circle.Normal)), (R, PixelValues.Of(circle.Radius))];

    private static (Symbol Name, PixelValues Value)[] NumbersOf(Aabb box) => [(B0, PixelValues.Of(box.Min)), (B1, PixelValues.Of(box.Max))];

    private static (Symbol Name, PixelValues Value)[] NumbersOf(Triangle triangle) =>
        [(A, PixelValues.Of(triangle.A)), (B, PixelValues.Of(triangle.B)), (C, PixelValues.Of(triangle.C))];

    private sealed record Part(Model Model, StepKind? Kind, (Symbol Name, PixelValues Value)[] Numbers)
    {
        /// <summary>Whether it is a whole mesh of many triangles.</summary>
        public bool IsLarge { get; init; }
    }

    /// <summary>The hits of a part.</summary>
    /// <param name="T">The first t that counts, in each pixel; NaN where none does.</param>
    private readonly record struct Crossed(double[] T)
    {
        /// <summary>Whether there is a hit, where a t of NaN may be one.</summary>
        public double[]? IsHit { get; init; }

        /// <summary>The second t, where it counts, too.</summary>
        public double[]? Far { get; init; }

        /// <summary>Whether the ray ends here with the background.</summary>
        public PixelValues? Ends { get; init; }

        /// <summary>The same in arrays of its own.</summary>
        public Crossed Copy() => new([.. T])
        {
            IsHit = IsHit is null ? null : [.. IsHit],
            Far = Far is null ? null : [.. Far],
            Ends = Ends?.Copy(),
        };
    }

    /// <param name="Frame">What camera and pixel have computed.</param>
    /// <param name="Nearest">The part that each pixel shows; −1 for none.</param>
    private sealed record State(FormulaProgram Program, PixelValues[] Frame, Crossed[] Hits, int[] Nearest, double[] T, byte[] Bytes)
    {
        /// <summary>The same in arrays of its own.</summary>
        public State Copy() => this with
        {
            Frame = [.. Frame.Select(batch => batch.X is null ? batch : batch.Copy())],
            Hits = [.. Hits.Select(hits => hits.Copy())],
            T = [.. T],
        };
    }

    /// <summary>Pixels that are computed together.</summary>
    private sealed class Group
    {
        /// <param name="count">How many values each array has; the last pixel's stands for more.</param>
        public Group((int X, int Y)[] pixels, int count)
        {
            Shown = pixels.Length;
            (X, Y) = (new(new double[count]), new(new double[count]));
            for (var i = 0; i < count; i++) (X.X[i], Y.X[i]) = pixels[Math.Min(i, Shown - 1)];
        }

        /// <summary>How many pixels are drawn.</summary>
        public int Shown { get; }

        /// <summary>Their columns.</summary>
        public PixelValues X { get; }

        /// <summary>Their lines.</summary>
        public PixelValues Y { get; }

        /// <summary>What the program draws there that others differ from.</summary>
        public State? Right { get; set; }
    }
}
