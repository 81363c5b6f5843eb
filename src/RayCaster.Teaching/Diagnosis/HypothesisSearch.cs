namespace RayCaster.Teaching.Diagnosis;

/// <summary>
/// Looks for the shortest explanations of a program's pictures: few and likely changes that leave few pixels unexplained. All single changes are
/// tried on few pixels and the best on more; then the shortest so far are extended by second changes that explain what they leave.
/// </summary>
/// <param name="pictures">The pictures, each of another scene; the bits of all are added.</param>
/// <param name="unreached">Lines that no loop may have reached; null for none.</param>
/// <param name="shortest">The bits of the shortest explanation without formulas; not found where one mistake is shorter than any.</param>
internal sealed class HypothesisSearch(
    IReadOnlyList<PictureSample> pictures, SearchOptions options, UnreachedLines? unreached, Lazy<double> shortest)
{
    // How much of the sample is looked at, as a share of it: by all hypotheses, and by the best of these. The last look is at all of it.
    private const double FirstLook = 0.008, SecondLook = 0.05;

    // By how many bits such a look may overrate what is left. What is longer than the shortest by more is not looked at again.
    private const double FirstLookSlack = 16, SecondLookSlack = 4;

    // How many hypotheses get each of the next looks.
    private const int MaxSecondLooks = 150, MaxFullLooks = 30;

    // How many changes of one's extensions get them.
    private const int MaxExtensions = 40, MaxFullExtensions = 8;

    // How many of the shortest hypotheses are extended by what costs little.
    private const int MaxBesideCheap = 12;

    // How many unfinished programs are extended by all known mistakes.
    private const int MaxUnfinished = 4;

    // How many hypotheses are extended by a second change; how many at least, even if two changes that are near are found before; and how many
    // stand ready because they draw the right colours.
    private const int MaxExtended = 90, MinExtended = 20, MaxByColors = 30;

    // What two known mistakes cost, in bits, and two that leave what rays along an edge may leave. A shorter hypothesis ends the search.
    private const double PairBits = 2 * (Priors.Known + Priors.Variant), NearPairBits = PairBits + 16;

    /// <summary>How many explanations are measured between two looks at the budget.</summary>
    private const int Together = 64;

    /// <summary>In a scene of more models no edits are tried.</summary>
    private const int MaxModels = 200;

    private readonly List<Hypothesis> found = []; // compared with all of the sample

    private double Bound => found.Where(of => !of.IsContradicted).Select(of => of.Total).Append(shortest.Value).Min();

    /// <summary>The hypotheses that were compared with all of the sample, the shortest explanation first.</summary>
    public List<Hypothesis> Run()
    {
        found.Add(Measure(Hypothesis.Right, 1, pictures)); // also if the time is over: there would be nothing to judge by
        try
        {
            Search();
            Add(Measured([.. found.OrderBy(of => of.Total).Take(10).Where(of => of.Changes.Length > 1).SelectMany(Less)], 1));
        }
        catch (TimeoutException)
        {
        }
        var alike = found.Where(of => of.Changes is [{ Mutation: not null }]).ToLookup(of => of.ResidualKey);
        // in the order in which it is told, too
        return [.. found.Where(of => !of.IsContradicted).OrderBy(of => of.Total).Select(of => Named(of, alike[of.ResidualKey]))
            .Where(of => of.Changes.All(change => change.Place is null || options.Possible?.Invoke(change) != false))];
    }

    /// <summary>Without each of its changes.</summary>
    private static IEnumerable<Hypothesis?> Less(Hypothesis of) =>
        of.Changes.Select(change => Hypothesis.Create(of.Changes.Remove(change)));

    /// <summary>With a name for each slip: a picture that several slips draw tells the likeliest.</summary>
    /// <param name="alike">The single slips that draw the same.</param>
    private static Hypothesis Named(Hypothesis of, IEnumerable<Hypothesis> alike)
    {
        if (of.Changes is not [{ Mutation: not null }])
            return of with { Changes = [.. of.Changes.Select(change => change.Mutation is null ? change : MutationNaming.Named([change]))] };
        Hypothesis[] same = [.. alike.OrderBy(other => other.Changes[0].Mutation!.Cost)];
        return same[0] with { Changes = [MutationNaming.Named([.. same.Select(other => other.Changes[0])])], Total = of.Total };
    }

    private void Search()
    {
        string[] kinds = [.. pictures.SelectMany(picture => picture.Scene.Models).Select(model => model.Kind).Distinct()];
        string[] parts = [.. kinds.Length > 1 ? kinds : [], MissingPart.Attenuation, MissingPart.Clipping];
        Change[] missing = [.. ChangeSource.Missing(parts.Except(options.Done))];
        Change[] named = [.. ChangeSource.From(options.Known, options.Likely)];
        var scene = pictures.MaxBy(picture => (double)picture.WrongCount / picture.PixelCount)!.Scene;
        Change[] wordings = scene.Models.Count > MaxModels ? [] : [.. ChangeSource.Wordings(scene, options.Known)];
        Change[] lines = unreached is null ? [] : [ChangeSource.From(unreached)];
        Change[] cheap = [.. lines, .. missing, .. ChangeSource.Styles(scene), .. named.Where(change => change.IsOtherSample)];

        // one change, or a program that is not finished
        var singles = Measured([.. named.Select(Hypothesis.Right.With)], FirstLook);
        var ways = Measured([.. Ways(missing, kinds.Length)], FirstLook);
        var others = Measured([.. lines.Concat(wordings).Select(Hypothesis.Right.With)], FirstLook);
        Refine([.. singles.Concat(ways).Concat(others).OrderBy(of => of.Total)]);
        if (found.Exists(of => !of.IsContradicted && of.Total < Priors.LeastWithoutFormulas) || Bound < Priors.Known + Priors.MissingPart) return;

        // with something that costs little, or in an unfinished program
        var changed = found.Where(of => of.Changes.Length > 0).OrderBy(of => of.Total);
        foreach (var one in changed.DistinctBy(of => of.ResidualKey).Take(MaxBesideCheap).ToArray()) Extend(one, cheap);
        if (Bound < Priors.Unknown) return;
        // a colour shows what is drawn, at any place
        var byColors = ways.Where(way => !way.MissingShapes.Any(kind => pictures.Any(picture => picture.Shows(kind))))
            .OrderByDescending(way => way.MissingShapes.Count).Take(MaxUnfinished);
        Hypothesis[] unfinished = [.. ways.Take(MaxUnfinished).Concat(byColors).Distinct()];
        foreach (var way in unfinished) Extend(way, named);
        if (Bound < PairBits) return;

        // two known changes, in turn beside the shortest so far, and beside one that draws the right colours
        Change[] seconds =
        [
            .. pictures.Any(picture => !picture.HasRightSize) ? named
                : singles.OrderBy(single => single.Bits).DistinctBy(single => (single.Changes[0].Id, single.ResidualKey))
                    .Select(single => single.Changes[0]),
            .. cheap,
        ];
        seconds = [.. seconds.Distinct()];
        Refine(Measured([.. PairsOfRays()], FirstLook));
        foreach (var one in singles.Where(IsOfBytes).DistinctBy(of => of.Changes[0].Id)) Extend(one, seconds);
        if (Bound < PairBits) return;
        var colors = pictures.Select(picture => picture.ByColors()).ToArray();
        var rest = new Queue<Hypothesis>(Measured([.. singles], FirstLook, colors).DistinctBy(of => of.ResidualKey).Take(MaxByColors));
        List<Hypothesis> extended = [];
        ExtendBest(MaxExtended / 3);
        if (Bound < NearPairBits) return;

        // an edit without a name, and two changes of which one may be such an edit
        Change[] edits = scene.Models.Count > MaxModels ? [] : [.. ChangeSource.Mutations(scene, options.Known)];
        Refine(Measured([.. edits.Select(Hypothesis.Right.With)], FirstLook));
        if (Bound < Priors.Known + Priors.Unknown) return;
        foreach (var one in found.Where(of => of.Changes.Length > 0).OrderBy(of => of.Total).Take(1).Concat(ways.Take(1))) Extend(one, edits);
        ExtendBest(MaxExtended);

        void ExtendBest(int most)
        {
            for (var turn = 0; extended.Count < most; turn++)
            {
                var first = turn % 2 == 1 && rest.Count > 0 ? rest.Dequeue()
                    : found.Where(of => of.Changes.Length is > 0 and < 4 && of.Gain > 0
                            && !extended.Exists(other => other.ResidualKey == of.ResidualKey))
                        .MinBy(of => of.Total);
                if (first is null && !rest.TryDequeue(out first)) return;
                if (Bound < NearPairBits && extended.Count >= MinExtended) return;
                if (extended.Contains(first)) continue; // two that draw the same alone may differ beside a second change
                extended.Add(first);
                if (first.Bits + Priors.Style < Bound) Extend(first, seconds);
            }
        }
    }

    /// <summary>Every subset of what may be missing, but for a program that draws nothing.</summary>
    private static IEnumerable<Hypothesis?> Ways(Change[] missing, int kinds) =>
        from bits in Enumerable.Range(1, (1 << missing.Length) - 1)
        let parts = missing.Where((_, i) => (bits >> i & 1) != 0)
        where parts.Count(part => MissingPart.IsShape(part.MissingPart!)) < kinds
        select parts.Aggregate((Hypothesis?)Hypothesis.Right, (all, part) => all?.With(part));

    /// <summary>Whether only colours or their places in the file are wrong, in the whole picture, so that it explains little alone.</summary>
    private static bool IsOfBytes(Hypothesis one) => one.Changes[0].Steps.All(step => step.IsOfColors() || step == StepKind.File);

    /// <summary>Two usual mistakes that both change which hits the whole picture shows: neither alone explains anything.</summary>
    private IEnumerable<Hypothesis?> PairsOfRays()
    {
        Change[] usual =
        [
            .. ChangeSource.From(options.Known.Where(mistake => mistake.Steps.Any(step => step.IsOfRays() || step.IsOfHits())), options.Likely)
                .DistinctBy(change => change.Id),
        ];
        return from i in Enumerable.Range(0, usual.Length)
               from second in usual[(i + 1)..]
               select Hypothesis.Right.With(usual[i])?.With(second);
    }

    private void Extend(Hypothesis first, IEnumerable<Change> changes)
    {
        PictureSample[] left = [.. pictures.Select(picture => new PictureSample(picture, first.Program))];
        var bound = Bound;
        var before = left.Sum(picture => (double)picture.WrongCount);
        var cheap = changes.Select(first.With).Where(with => with is not null && with.Bits < bound + Priors.AsLikely);
        var measured = Measured([.. cheap], FirstLook, left);
        var promising = measured.Where(with =>
            with.Total < bound + FirstLookSlack && with.Residuals.Sum(residual => residual.Unexplained) < 0.98 * before).Take(MaxExtensions);
        var best = Measured([.. promising], SecondLook, left).Where((with, i) => i < 2 || with.Total < bound + SecondLookSlack)
            .Take(MaxFullExtensions);
        Add(Measured([.. best], 1).Select(with => with with { Gain = first.Total - with.Total }));
    }

    /// <summary>Looks at the best more closely, and at the best of these at all of the sample.</summary>
    private void Refine(List<Hypothesis> candidates)
    {
        var closer = Measured([.. candidates.Take(MaxSecondLooks)], SecondLook);
        Add(Measured([.. closer.Take(MaxFullLooks)], 1));
    }

    /// <summary>Adds those that were compared with all of the sample. Only the short ones can be named, so only these are held against what the
    /// pictures prove.</summary>
    private void Add(IEnumerable<Hypothesis> measured) => found.AddRange(measured.Select(of => of with
    {
        IsContradicted = of.Changes.Length > 0 && of.Total < pictures.Count * Priors.Mentioned
            && pictures.Any(picture => picture.Contradicts(of.Program, of.IsAbout)),
    }));

    /// <summary>Compares them with a share of the sample, and sorts them.</summary>
    private List<Hypothesis> Measured(IReadOnlyList<Hypothesis?> candidates, double share, IReadOnlyList<PictureSample>? left = null)
    {
        var sample = left ?? pictures;
        Hypothesis[] measured = [.. candidates.OfType<Hypothesis>()];
        var done = SearchBudget.Do(options.Budget, measured.Length, Together, options.Threads,
            i => measured[i] = Measure(measured[i], share, sample));
        if (done < measured.Length) throw new TimeoutException();
        return [.. measured.OrderBy(one => one.Total)]; // those with the same total in the order of the candidates
    }

    private static Hypothesis Measure(Hypothesis candidate, double share, IReadOnlyList<PictureSample> sample)
    {
        ImmutableArray<Residual> residuals = [.. sample.Select(picture => picture.Residual(candidate.Program, share))];
        return candidate with
        {
            Residuals = residuals,
            Total = candidate.Bits + residuals.Select((residual, i) => sample[i].BitsOf(residual)).Sum(),
        };
    }
}
