namespace RayCaster.Teaching.Formulas;

/// <summary>The loop over a scene's models: which part each pixel shows.</summary>
/// <param name="count">How many values each array has.</param>
internal sealed class NearestLoop(ImmutableArray<ShapePart> parts, PixelArithmetic arithmetic, int count)
{
    private static readonly Symbol parameter = Symbol.From("t"), best = Symbol.From("best");

    /// <summary>Which part each pixel shows, −1 for none, and at which t.</summary>
    public (int[] Part, double[] T) Nearest(FormulaProgram program, PartHits[] crossed, PixelValues[] camera, bool isUsual)
    {
        int[] drawn = [.. Enumerable.Range(0, parts.Length).Where(k => !program.MissingShapes.Contains(parts[k].Model.Kind)
            && !(program.HasNoisyTriangles && parts[k].Kind == StepKind.Triangle))];
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
    private void Choose(Step loop, int[] drawn, PartHits[] crossed, PixelValues[] camera, int[] nearest, double[] shownT)
    {
        var frame = PixelArithmetic.FrameOf(camera, new PixelValues[Symbol.Max], [(parameter, new(shownT)), (best, new(shownT))]);
        arithmetic.Define(loop, frame);
        var start = frame[Symbol.From("start").Place];
        var offersBoth = frame[Symbol.From("both").Place][0] != 0;
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
                for (; k + 1 < drawn.Length && parts[drawn[k + 1]].Model == mesh; k++) PartHits.Offer(hits, crossed[drawn[k + 1]].T);
            }
            OfferAll(drawn[first], hits, crossed[drawn[first]].IsHit);
            if (offersBoth && crossed[drawn[first]].Far is { } far) OfferAll(drawn[first], far, null);
        }
        (frame[parameter.Place], frame[best.Place]) = (new(shownT), new(least));
        arithmetic.Define(loop, frame);
        var kept = frame[Symbol.From("kept").Place];
        for (var i = 0; i < count; i++)
            if (kept[i] == 0) nearest[i] = -1;

        void OfferAll(int part, double[] t, double[]? isHit)
        {
            frame[parameter.Place] = new(t);
            var used = arithmetic.Used;
            arithmetic.Define(loop, frame);
            var (better, replaces, lights) =
                (frame[Symbol.From("better").Place], frame[Symbol.From("replaces").Place], frame[Symbol.From("lights").Place]);
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
}
