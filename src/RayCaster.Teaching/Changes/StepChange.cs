namespace RayCaster.Teaching.Changes;

/// <summary>What a change does in one step of a program, or what no formula says.</summary>
internal abstract class StepChange
{
    /// <summary>The steps whose formulas it changes: for a rule of some kinds of shape these shapes, for a style none.</summary>
    public abstract IEnumerable<StepKind> Steps { get; }

    /// <summary>A program with it; null if the program has a change of the same place, or another style.</summary>
    public abstract FormulaProgram? In(FormulaProgram program);

    /// <summary>Other formulas of a step, or another style of it, as Mistakes.txt has them.</summary>
    /// <param name="style">The style; the first one if null.</param>
    /// <param name="shapes">The kinds of shape whose rule it is; empty for all.</param>
    public sealed class Written(
        StepKind kind, string? style, ImmutableArray<StepKind> shapes, ImmutableArray<(string Name, string Right)> formulas) : StepChange
    {
        /// <summary>Each step with the formulas: a search asks for it thousands of times.</summary>
        private readonly ConditionalWeakTable<Step, Step> edited = [];

        public StepKind Kind => kind;

        public string? Style => style;

        public ImmutableArray<StepKind> Shapes => shapes;

        public ImmutableArray<(string Name, string Right)> Formulas => formulas;

        public override IEnumerable<StepKind> Steps => !shapes.IsEmpty ? shapes : formulas.IsEmpty ? [] : [kind];

        /// <summary>A step with the formulas.</summary>
        public Step In(Step step) => formulas.IsEmpty ? step
            : edited.GetValue(step, own => formulas.Aggregate(own, (all, formula) => all.With(formula.Name, formula.Right)));

        public override FormulaProgram? In(FormulaProgram program) => program.With(In(StyleOf()), shapes);

        /// <summary>The step without the formulas.</summary>
        private Step StyleOf() => style is null ? FormulaBook.Slides.StylesOf(kind)[0] : FormulaBook.Slides[kind, style];
    }

    /// <summary>A step with a slip.</summary>
    public sealed class Mutated(Step step) : StepChange
    {
        public override IEnumerable<StepKind> Steps => [step.Kind];

        public override FormulaProgram? In(FormulaProgram program) => program.With(step, []);
    }

    /// <summary>Another right style of a step, where a program has the usual one.</summary>
    public sealed class OtherStyle(Step style) : StepChange
    {
        public override IEnumerable<StepKind> Steps => [];

        public override FormulaProgram? In(FormulaProgram program) =>
            program[style.Kind] == FormulaBook.Slides.StylesOf(style.Kind)[0] ? program.With(style) : null;
    }

    /// <summary>A kind of shape, by its name in scene files, that is not drawn.</summary>
    public sealed class MissingShape(string kind) : StepChange
    {
        public override IEnumerable<StepKind> Steps => [];

        public override FormulaProgram? In(FormulaProgram program) =>
            program.MissingShapes.Contains(kind) ? null : program with { MissingShapes = program.MissingShapes.Add(kind) };
    }

    /// <summary>The camera stands at T and looks at P.</summary>
    public sealed class SwappedEyeAndTarget : StepChange
    {
        public override IEnumerable<StepKind> Steps => [StepKind.Camera];

        public override FormulaProgram? In(FormulaProgram program) => program.SwapsEyeAndTarget ? null : program with { SwapsEyeAndTarget = true };
    }

    /// <summary>Last bits decide where a triangle shows.</summary>
    public sealed class NoisyTriangles : StepChange
    {
        public override IEnumerable<StepKind> Steps => [StepKind.Triangle];

        public override FormulaProgram? In(FormulaProgram program) => program.HasNoisyTriangles ? null : program with { HasNoisyTriangles = true };
    }

    /// <summary>No loop reaches some lines and columns.</summary>
    public sealed class Unreached(UnreachedLines lines) : StepChange
    {
        public override IEnumerable<StepKind> Steps => [];

        public override FormulaProgram? In(FormulaProgram program) => program.Unreached is null ? program with { Unreached = lines } : null;
    }

    /// <summary>All bytes of the picture are farther on in the file.</summary>
    public sealed class ByteShift(int count) : StepChange
    {
        public override IEnumerable<StepKind> Steps => [StepKind.File];

        public override FormulaProgram? In(FormulaProgram program) => program.ByteShift != 0 ? null : program with { ByteShift = count };
    }
}
