namespace RayCaster.Teaching.Formulas;

/// <summary>Crosses the parts of a scene with the rays of some pixels, by the formulas of their shapes and by the rule that says which crossing
/// counts.</summary>
/// <param name="count">How many values each array has.</param>
internal sealed class ShapeCrosser(Scene scene, ImmutableArray<ShapePart> parts, PixelArithmetic arithmetic, int count)
{
    /// <summary>What a ray through a mesh's tree, or to a shape of one's own, takes, and each triangle that it meets there, as so many computed
    /// numbers do.</summary>
    private const int WorkOfRay = 200, WorkOfTriangle = 40;

    private static readonly Symbol pointP = Symbol.From("P"), direction = Symbol.From("d"), parameter = Symbol.From("t"), axisW = Symbol.From("W");

    private readonly PixelValues[] ofShape = new PixelValues[Symbol.Max], ofRule = new PixelValues[Symbol.Max]; // used again and again

    /// <summary>The hits of a part.</summary>
    /// <param name="camera">What camera and pixel have computed.</param>
    /// <param name="withAll">Whether a t that is no number may be a hit, and the second crossing is needed, too.</param>
    public PartHits Cross(int part, FormulaProgram program, Step rule, PixelValues[] camera, bool withAll)
    {
        var (model, kind, numbers) = parts[part];
        if (kind is null) return HitsOf(model, rule, camera);
        var used = arithmetic.Used;
        var step = program[kind.Value];
        var frame = PixelArithmetic.FrameOf(camera, ofShape, numbers);
        arithmetic.Define(step, frame);
        var crossed = Counted(step, rule, frame, camera, withAll);
        arithmetic.GiveBack(used, crossed.T, crossed.IsHit, crossed.Far, crossed.Ends?.X);
        return crossed;
    }

    /// <summary>The first crossing of a shape that counts, in each pixel.</summary>
    /// <param name="frame">What the shape's formulas have computed.</param>
    /// <param name="withAll">Whether a t that is no number may be a hit, and the second crossing is needed, too.</param>
    private PartHits Counted(Step step, Step rule, PixelValues[] frame, PixelValues[] camera, bool withAll)
    {
        var one = PixelValues.From(1);
        var when = step.Has(Formula.When) ? frame[Formula.When.Place] : one;
        var first = ByRule(frame[Formula.Near.Place], rule, camera);
        var second = step.Has(Formula.Far) ? ByRule(frame[Formula.Far.Place], rule, camera) : default;
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
        var frame = PixelArithmetic.FrameOf(camera, ofRule, []);
        frame[parameter.Place] = crossing;
        arithmetic.Define(rule, frame);
        var counts = rule.Has(Formula.When) ? frame[Formula.When.Place] : PixelValues.From(1);
        return (frame[Formula.Near.Place], counts, Of(Formula.Ends), Of(Formula.Second));

        PixelValues? Of(Symbol name) => rule.Has(name) ? frame[name.Place] : null;
    }

    /// <summary>The hits of a model whose own formulas are the definition's: a large mesh, a shape of one's own.</summary>
    private PartHits HitsOf(Model model, Step rule, PixelValues[] camera)
    {
        var isUsual = FormulaBook.Slides.StylesOf(rule.Kind)[0] == rule;
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
                arithmetic.Work += WorkOfTriangle;
                var t = (double)mesh[triangle].Intersect(new Ray<Scalar>(origin, d)).Near;
                return !isUsual ? Counts(t, i) : ray.Counts(t) ? t : null;
            })) ?? double.NaN;
        }
        return new(hits);

        double? Counts(double t, int pixel)
        {
            if (double.IsNaN(t)) return null;
            var only = (PixelValues[])camera.Clone();
            only[direction.Place] = PixelValues.From(camera[direction.Place].At(pixel));
            var (own, counts, _, _) = ByRule(PixelValues.From(t), rule, only);
            return counts[0] != 0 ? own[0] : null;
        }
    }
}
