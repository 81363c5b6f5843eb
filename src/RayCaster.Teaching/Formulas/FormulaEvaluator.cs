using System.Numerics;

namespace RayCaster.Teaching.Formulas;

/// <summary>Draws pixels of a scene as programs do. Of a program that differs from the first one, it computes only what the difference reaches.
/// </summary>
/// <remarks>Not for several threads.</remarks>
internal sealed class FormulaEvaluator
{
    /// <summary>How many pixels are computed together, at most: their numbers stay in the processor's cache.</summary>
    private const int MaxTogether = 1024;

    private static readonly UInt128 ofRay = Symbol.From("P").Bit | Symbol.From("d").Bit;

    private readonly Scene scene;
    private readonly int count; // pixels of a group: those that are drawn, and with the last one again and again as many as the arithmetic needs
    private readonly PixelArithmetic arithmetic;
    private readonly PixelValues[] givens;
    private readonly ImmutableArray<ShapePart> parts;
    private readonly ShapeCrosser crosser;
    private readonly NearestLoop loop;
    private readonly Group[] groups;
    private readonly FormulaProgram? right;
    private readonly PixelValues[] ofPixel = new PixelValues[Symbol.Max], ofColor = new PixelValues[Symbol.Max]; // used again and again

    /// <param name="pixels">Columns from the left and lines from the top of the file.</param>
    /// <param name="right">The program that others differ from; null if there will be only one.</param>
    /// <param name="other">A number that the scene gives otherwise: of a part, or of the camera for −1; null for none.</param>
    public FormulaEvaluator(Scene scene, IReadOnlyList<(int X, int Y)> pixels, FormulaProgram? right = null,
        (int Part, Symbol Name, PixelValues Value)? other = null)
    {
        (this.scene, this.right) = (scene, right);
        var number = Math.Max(1, (pixels.Count + MaxTogether - 1) / MaxTogether);
        var shown = (pixels.Count + number - 1) / number;
        count = (shown + Vector<double>.Count - 1) / Vector<double>.Count * Vector<double>.Count;
        groups = [.. Enumerable.Range(0, number).Select(i => new Group([.. pixels.Skip(i * shown).Take(shown)], count))];
        arithmetic = new(count);
        givens = GivensOf(scene.Camera);
        parts = [.. scene.Models.SelectMany(ShapePart.From)];
        if (other is (-1, var given, var own)) givens[given.Place] = own;
        else if (other is var (part, name, value))
            parts = parts.SetItem(part, parts[part] with
            {
                Numbers = [.. parts[part].Numbers.Select(number => number.Name == name ? (name, value) : number)],
            });
        crosser = new(scene, parts, arithmetic, count);
        loop = new(parts, arithmetic, count);
        if (right is null) return;
        foreach (var group in groups) group.Right = Run(right, group).Copy();
    }

    /// <summary>The values of the names that every scene gives, each at its symbol's place.</summary>
    public static PixelValues[] GivensOf(Camera camera)
    {
        var givens = new PixelValues[Symbol.Max];
        Give("P", PixelValues.From(camera.Position));
        Give("T", PixelValues.From(camera.Target));
        Give("up", PixelValues.From(camera.Up));
        Give("fovY", PixelValues.From(camera.FovY));
        Give("width", PixelValues.From(camera.Width));
        Give("height", PixelValues.From(camera.Height));
        Give("byDepth", PixelValues.From(camera.Clip == ClipMode.Depth ? 1 : 0));
        Give("zNear", PixelValues.From(camera.ZNear));
        Give("zFar", PixelValues.From(Math.Min(camera.ZFar, double.MaxValue))); // so that the infinite t of a parallel ray never counts
        Give("bias", PixelValues.From(camera.Bias == 0 ? -double.Epsilon : camera.Bias)); // with a bias of 0, t = 0 counts
        Give("∞", PixelValues.From(double.PositiveInfinity));
        Give("π", PixelValues.From(Math.PI));
        return givens;

        void Give(string name, PixelValues value) => givens[Symbol.From(name).Place] = value;
    }

    /// <summary>What a program draws in some pixels, of which there may be many: red, green, blue, and so on.</summary>
    /// <param name="pixels">Columns from the left and lines from the top of the program's file.</param>
    /// <param name="budget">What is spent; null if it is not counted.</param>
    public static byte[] Draw(Scene scene, FormulaProgram program, IReadOnlyList<(int X, int Y)> pixels, SearchBudget? budget = null) =>
        pixels.Count == 0 ? [] // all bytes of the pixels that are asked for may have moved out of the file
            : program.ByteShift != 0 ? DrawMoved(scene, program, pixels, budget) : new FormulaEvaluator(scene, pixels).Draw(program, budget);

    /// <summary>The same where a byte comes from another place in the file; what is before the first or after the last one is a line break.
    /// </summary>
    private static byte[] DrawMoved(Scene scene, FormulaProgram program, IReadOnlyList<(int X, int Y)> pixels, SearchBudget? budget)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        if (program.IsTurned) (width, height) = (height, width);
        int[] sources = [.. from pixel in pixels from channel in (int[])[0, 1, 2]
            select 3 * (pixel.Y * width + pixel.X) + channel - program.ByteShift];
        int[] places = [.. sources.Where(IsInFile).Select(source => source / 3).Distinct()];
        var drawn = Draw(scene, program with { ByteShift = 0 }, [.. places.Select(place => (place % width, place / width))], budget);
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
        if (program.Unreached is { } lines)
            foreach (var (at, (x, y)) in groups.SelectMany(group => group.Pixels).Index().Where(pixel => lines.Contains(pixel.Item.X, pixel.Item.Y)))
                (rgb[3 * at], rgb[3 * at + 1], rgb[3 * at + 2]) = lines.Color;
        return rgb;
    }

    /// <returns>What the next run overwrites.</returns>
    private State Run(FormulaProgram program, Group group)
    {
        var basis = group.Right;
        (givens[Symbol.From("x").Place], givens[Symbol.From("y").Place]) = (group.X, group.Y);
        arithmetic.GiveBack(0);
        arithmetic.Functions = program[StepKind.Vectors];
        var changed = basis is null || arithmetic.Functions == basis.Program[StepKind.Vectors] ? 0 : arithmetic.Functions.Names;
        var frame = PixelArithmetic.FrameOf(givens, ofPixel, []);
        if (program.SwapsEyeAndTarget)
            (frame[pointP.Place], frame[pointT.Place]) = (frame[pointT.Place], frame[pointP.Place]);
        if (basis is not null && basis.Program.SwapsEyeAndTarget != program.SwapsEyeAndTarget) changed |= pointP.Bit | pointT.Bit;
        foreach (var kind in (ReadOnlySpan<StepKind>)[StepKind.Camera, StepKind.File, StepKinds.SampleOf(scene.Camera), StepKind.Pixel])
            arithmetic.Define(program[kind], frame, basis?.Program[kind], basis?.Frame, ref changed);

        var nearestStep = program[StepKind.Nearest];
        var isUsual = nearestStep == FormulaBook.Slides.StylesOf(StepKind.Nearest)[0];
        var sameLoop = basis is not null && nearestStep == basis.Program[StepKind.Nearest];
        var areNew = !sameLoop || !program.MissingShapes.SetEquals(basis!.Program.MissingShapes)
            || program.HasNoisyTriangles != basis.Program.HasNoisyTriangles;
        var crossed = new PartHits[parts.Length];
        var kindOfRule = StepKinds.RuleOf(scene.Camera);
        for (var i = 0; i < parts.Length; i++)
        {
            var part = parts[i];
            var rule = program.RuleOf(part.Kind, kindOfRule);
            var isSame = sameLoop && ReferenceEquals(rule, basis!.Program.RuleOf(part.Kind, kindOfRule)) && (rule.Reads & changed) == 0
                && (part.Kind is { } kind ? IsSame(kind) : (changed & ofRay) == 0);
            areNew |= !isSame;
            crossed[i] = isSame ? basis!.Hits[i] : crosser.Cross(i, program, rule, frame, !isUsual);
        }
        var (nearest, t) = areNew ? loop.Nearest(program, crossed, frame, isUsual) : (basis!.Nearest, basis.T);
        if (!areNew && IsSame(StepKind.Light) && IsSame(StepKind.Bytes) && (Formula.Written.Bit & changed) == 0
            && program[StepKind.File].Has(Formula.Written) == basis!.Program[StepKind.File].Has(Formula.Written)) return basis;
        return new(program, frame, crossed, nearest, t, BytesOf(program, frame, nearest, t, group.Shown));

        bool IsSame(StepKind kind) =>
            basis is not null && ReferenceEquals(program[kind], basis.Program[kind]) && (program[kind].Reads & changed) == 0;
    }

    private static readonly Symbol pointP = Symbol.From("P"), pointT = Symbol.From("T"), parameter = Symbol.From("t");

    private byte[] BytesOf(FormulaProgram program, PixelValues[] camera, int[] nearest, double[] t, int shown)
    {
        var frame = PixelArithmetic.FrameOf(camera, ofColor, []);
        var own = arithmetic.NewVector(count);
        var seen = arithmetic.NewVector(count);
        for (var i = 0; i < count; i++) own.Set(i, ColorOf(nearest[i]));
        frame[parameter.Place] = new(t);
        frame[Symbol.From("K").Place] = own;
        arithmetic.Define(program[StepKind.Light], frame);
        var lit = frame[Symbol.From("colour").Place];
        for (var i = 0; i < count; i++) seen.Set(i, nearest[i] < 0 ? own.At(i) : lit.At(i)); // the background does not fade
        frame[Symbol.From("colour").Place] = seen;
        arithmetic.Define(program[StepKind.Bytes], frame);
        var rgb = frame[Symbol.From("rgb").Place];
        var isWritten = program[StepKind.File].Has(Formula.Written) ? camera[Formula.Written.Place] : PixelValues.From(1);
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
    public static StepKind? KindOf(Model model) => ShapePart.From(model).First().Kind;

    /// <param name="Frame">What camera and pixel have computed.</param>
    /// <param name="Nearest">The part that each pixel shows; −1 for none.</param>
    private sealed record State(FormulaProgram Program, PixelValues[] Frame, PartHits[] Hits, int[] Nearest, double[] T, byte[] Bytes)
    {
        /// <summary>The same in arrays of its own.</summary>
        public State Copy() => this with
        {
            Frame = [.. Frame.Select(values => values.X is null ? values : values.Copy())],
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
            (Pixels, Shown) = (pixels, pixels.Length);
            (X, Y) = (new(new double[count]), new(new double[count]));
            for (var i = 0; i < count; i++) (X.X[i], Y.X[i]) = pixels[Math.Min(i, Shown - 1)];
        }

        /// <summary>Their columns and lines.</summary>
        public (int X, int Y)[] Pixels { get; }

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
