using static RayCaster.Teaching.SectionKind;
using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>Steps by the texts of the slides' formulas, for each pixel alone: slower than code, but any edit can be drawn like a mistake of the
/// catalogue.</summary>
internal sealed partial class Lab
{
    private static readonly Symbol pointP = Symbol.Of("P"), pointT = Symbol.Of("T"), axisU = Symbol.Of("U"), axisV = Symbol.Of("V"),
        axisW = Symbol.Of("W"), height = Symbol.Of("h"), width = Symbol.Of("w"), column = Symbol.Of("c"), row = Symbol.Of("r"), x = Symbol.Of("x"),
        y = Symbol.Of("y"), direction = Symbol.Of("d"), parameter = Symbol.Of("t"), own = Symbol.Of("K"), colour = Symbol.Of("colour"),
        bytes = Symbol.Of("rgb");

    /// <summary>Has those steps done by a program's formulas in which it differs from the slides'.</summary>
    public void Follow(FormulaProgram program)
    {
        var right = FormulaProgram.For(Camera);
        var arithmetic = new BatchArithmetic(0) { Functions = program[Vectors] };
        var camera = new Lazy<Batch[]>(() =>
        {
            var frame = FormulaEvaluator.GivensOf(Camera);
            (frame[pointP.Place], frame[pointT.Place]) = (Batch.Of(P), Batch.Of(T));
            return Computed(frame, SectionKind.Camera);
        });
        var rays = new Lazy<Batch[]>(() =>
        {
            var frame = (Batch[])camera.Value.Clone();
            (frame[axisU.Place], frame[axisV.Place], frame[axisW.Place], frame[height.Place], frame[width.Place]) =
                (Batch.Of(U), Batch.Of(V), Batch.Of(W), Batch.Of(h), Batch.Of(w));
            return frame;
        });
        if (Differs(SectionKind.Camera))
        {
            AxisW.Is(_ => camera.Value[axisW.Place].At(0));
            AxisU.Is((_, _) => camera.Value[axisU.Place].At(0));
            AxisV.Is((_, _) => camera.Value[axisV.Place].At(0));
            PlaneHeight.Is(_ => camera.Value[height.Place][0]);
            PlaneWidth.Is(_ => camera.Value[width.Place][0]);
        }
        if (Differs(SectionKind.File))
        {
            Sample.Is((c, r) =>
            {
                var frame = Of(SectionKind.File, (x, Batch.Of(c)), (y, Batch.Of(Camera.Height - 1 - r)));
                return (frame[column.Place][0], frame[row.Place][0]);
            });
        }
        if (Differs(Pixel))
        {
            Uc.Is(c => c);
            Ur.Is(r => r);
            Direction.Is(d => d);
            Towards.Is((c, r) => Of(Pixel, (column, Batch.Of(c)), (row, Batch.Of(r)),
                (x, Batch.Of(c - half)), (y, Batch.Of(Camera.Height - 1 - r + half)))[direction.Place].At(0));
        }
        if (Differs(SectionKind.Plane)) Plane.Is((plane, d) => Crossed(SectionKind.Plane, d, FormulaEvaluator.NumbersOf(plane)));
        if (Differs(SectionKind.Sphere)) Sphere.Is((sphere, d) => Crossed(SectionKind.Sphere, d, FormulaEvaluator.NumbersOf(sphere)));
        if (Differs(SectionKind.Aabb)) Box.Is((box, d) => Crossed(SectionKind.Aabb, d, FormulaEvaluator.NumbersOf(box)));
        if (Differs(SectionKind.Circle)) Circle.Is((circle, d) => Crossed(SectionKind.Circle, d, FormulaEvaluator.NumbersOf(circle)));
        if (Differs(SectionKind.Triangle)) TriangleIs((triangle, d) => Crossed(SectionKind.Triangle, d, FormulaEvaluator.NumbersOf(triangle)));
        if (Differs(Rule)) First.Is((crossed, d) => Counted(crossed.Near, d) ?? Counted(crossed.Far, d));
        if (Differs(Light))
        {
            Shaded.Is((t, d, color) =>
            {
                var (r, g, b) = Of(Light, (parameter, Batch.Of(t)), (direction, Batch.Of(d)), (own, Batch.Of(VectorOf(color))))[colour.Place].At(0);
                return new(r, g, b);
            });
        }
        if (Differs(SectionKind.Bytes))
        {
            Encoded.Is(color =>
            {
                var (r, g, b) = Of(SectionKind.Bytes, (colour, Batch.Of(VectorOf(color))))[bytes.Place].At(0);
                return ((byte)r, (byte)g, (byte)b);
            });
        }

        bool Differs(SectionKind kind) => program[Vectors] != right[Vectors] || program[kind] != right[kind];

        Batch[] Computed(Batch[] frame, SectionKind kind)
        {
            foreach (var formula in program[kind].Formulas) frame[formula.Name.Place] = arithmetic.Evaluate(formula.Right, frame);
            return frame;
        }

        Batch[] Of(SectionKind kind, params ReadOnlySpan<(Symbol Name, Batch Value)> numbers)
        {
            var frame = (Batch[])rays.Value.Clone();
            foreach (var (name, value) in numbers) frame[name.Place] = value;
            return Computed(frame, kind);
        }

        Crossed Crossed(SectionKind kind, Vector3 d, ReadOnlySpan<(Symbol Name, Batch Value)> numbers)
        {
            var frame = Of(kind, [.. numbers, (direction, Batch.Of(d))]);
            if (!IsHit(program[kind], frame)) return SlideFormulas.None;
            var near = frame[Formula.Near.Place][0];
            return program[kind].Has(Formula.Far) ? new(near, frame[Formula.Far.Place][0]) : new(near);
        }

        double? Counted(double t, Vector3 d)
        {
            if (double.IsNaN(t)) return null;
            var frame = Of(Rule, (parameter, Batch.Of(t)), (direction, Batch.Of(d)));
            return IsHit(program[Rule], frame) ? frame[Formula.Near.Place][0] : null;
        }
    }

    private static bool IsHit(FormulaSection section, Batch[] frame) => !section.Has(Formula.When) || frame[Formula.When.Place][0] != 0;

    private static Vector3 VectorOf(Color color) => new(color.R, color.G, color.B);
}
