namespace RayCaster.Teaching;

/// <summary>
/// Tries unfinished programs, each mistake in each of its variants, and pairs of them, on the <see cref="Evidence"/> of a program's pictures.
/// </summary>
/// <param name="pictures">The pictures, each of another scene.</param>
/// <param name="done">What the program certainly draws.</param>
/// <param name="threads">How many threads draw; one per core if null.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
/// <param name="budget">How long the search may take; null for any time.</param>
/// <param name="possible">Which edits of formulas are tried that are not in the catalogue; all if null.</param>
internal sealed class DiagnosisSearch(IReadOnlyList<Evidence> pictures, IReadOnlyList<Mistake> known, IReadOnlyCollection<string> done,
    int? threads, Predicate<Mistake>? likely, SearchBudget? budget = null, Predicate<Mistake>? possible = null)
{
    /// <summary>If a mistake leaves at most this share, its other variants are tried once more.</summary>
    private const double WorthVariants = 0.1;

    /// <summary>The search ends at this share if shapes are missing, whose pixels a second mistake may explain.</summary>
    private const double Nearly = 0.001;

    /// <summary>How many of the nearest mistakes are also tried with rays through the other sample point of each pixel.</summary>
    private const int OtherSamples = 6;

    /// <summary>How many of the nearest mistakes are tried beside each way to be unfinished.</summary>
    private const int Besides = 3;

    /// <summary>How many ways to be unfinished are tried together with mistakes.</summary>
    private const int Ways = 8;

    /// <summary>Mistakes that come after others that draw the same picture, because fewer people make them.</summary>
    private static readonly string[] rare = ["v-cross", "clip-root", "znear-t", "zfar-t"];

    private readonly Mistake[] known = [.. known.OrderBy(mistake => rare.Contains(mistake.Id))];

    private readonly List<WrongProgram> parts = []; // known edits of formulas that explain some of what is wrong

    private readonly string[] kinds = Unfinished.KindsOf(pictures);

    /// <summary>Compares and sorts the candidates.</summary>
    public CandidateRanking Ranking { get; } = new(pictures, threads, likely);

    /// <summary>All candidates that were compared closely, the best first.</summary>
    public List<WrongProgram> Run()
    {
        Unfinished[] unfinished = [.. Unfinished.Ways(pictures, done)];
        var plain = Ranking.Best(
            [.. from way in unfinished from otherSample in (bool[])[false, true] select new WrongProgram(way, [], otherSample)]);
        Ranking.Budget = budget; // without a single candidate there would be nothing to judge by
        try
        {
            return Run(unfinished, plain);
        }
        catch (TimeoutException)
        {
            return Ranking.Sorted([.. plain, .. Ranking.Closest]);
        }
        finally
        {
            Ranking.Budget = null;
        }
    }

    private List<WrongProgram> Run(Unfinished[] unfinished, List<WrongProgram> plain)
    {
        var (usual, everySingle) = NearestSingles();
        var pairs = new PairSearch(pictures, known, Ranking, everySingle);
        List<WrongProgram> singles = usual, early = [];
        if (!Ranking.IsCertain([.. plain, .. usual]))
        {
            // A search for edits takes as long as all the rest. It is not needed if all shapes show and two known mistakes explain everything.
            if (!Unfinished.ByColors(pictures, done).Any(way => way.Kinds.Any()))
                early = Ranking.BestPairs(pairs.WithNearest(usual, PairSearch.Partners));
            if (!Ranking.IsCertain(early)) (singles, early) = (Ranking.Sorted([.. usual, .. Edits(Unfinished.Nothing)]), []);
        }
        singles = WithoutIdle(singles);
        if (pictures is [var only] && singles.Exists(single => single.Misfit.Unexplained < only.LeastPixels && Ranking.IsCertain([single])))
            return Ranking.Sorted([.. plain, .. singles]);
        // A missing shape counts for little beside a mistake that changes everything, so it is sought even if the mistake explains most.
        var beside = Ranking.Best(
        [
            .. from single in usual.DistinctBy(single => single.Id).Take(Besides).Union(singles.DistinctBy(single => single.Id).Take(Besides))
               from way in unfinished
               where way.Kinds.Any() && single.Variants.All(variant => MayShow(variant, way))
               select single with { Base = way },
        ]);
        List<WrongProgram> all = [.. plain, .. singles, .. beside];
        if (Ranking.IsCertain([.. all.Where(candidate => !candidate.Base.Kinds.Any())]) || Ranking.IsDone(all, Nearly)) return Ranking.Sorted(all);

        var isDone = Ranking.IsDone(all);
        if (isDone) all.AddRange(NearestPairs());
        if (isDone && !Ranking.IsDone(plain)) return Ranking.Sorted(all);

        // Few wrong pixels beside what is missing may be all that shows of a mistake.
        bool[] samples = plain is [{ OtherSample: true }, ..] ? [true] : [false];
        var onTop = Ranking.Best([.. NearestWays(samples).SelectMany(way => Singles(way, samples))]);
        all.AddRange([.. onTop, .. early]);
        if (!isDone && Ranking.IsDone(all) && !Ranking.IsDone(all, Nearly)) all.AddRange(NearestPairs());
        if (Ranking.IsDone(all)) return Ranking.Sorted(all);

        var nearest = Ranking.Sorted([.. plain, .. onTop]).FirstOrDefault();
        if (nearest is { Base.NotYet.Count: > 0 } && !nearest.Base.Kinds.Any())
        {
            // All shapes are there, only light or clipping is not: one edit is likelier than two mistakes.
            all.AddRange(Edits(nearest.Base));
            if (Ranking.IsCertain(all)) return Ranking.Sorted(all);
        }
        foreach (var some in pairs.ByEffort(Ranking.Sorted([.. singles, .. parts]), onTop))
        {
            var best = Ranking.BestPairs(some);
            if (!Ranking.IsCertain(best)) best = Ranking.Sorted([.. best, .. Ranking.Best(InOtherVariants(best, Besides))]);
            all.AddRange(best);
            if (Ranking.IsCertain(all)) break;
        }
        // An edit takes longest to find, and pairs of known mistakes explain most pictures.
        if (!Ranking.IsDone(all) && nearest is not null && nearest.Base.Kinds.Any())
        {
            all.AddRange(Edits(nearest.Base));
            // A kind that seems to be missing may be what the edit loses; then it shows in what is there of that kind.
            all.AddRange(Edits(new([.. nearest.Base.NotYet.Except(nearest.Base.Kinds)]), nearest with { Variants = [] }));
        }
        return Ranking.Sorted(all);

        List<WrongProgram> NearestPairs() => Ranking.BestPairs(pairs.WithNearest([.. Ranking.Sorted(all).SelectMany(Written)], 2));
    }

    /// <summary>The nearest single mistakes of a finished program, and all of them after a screening.</summary>
    private (List<WrongProgram> Nearest, List<WrongProgram> All) NearestSingles()
    {
        var mayBeOtherSample = MayBeOtherSample();
        Scene[] meshes = [.. pictures.Select(picture => picture.Scene).Where(scene => scene.Models.Any(model => model is Mesh))];
        var isSlow = Singles(Unfinished.Nothing, mayBeOtherSample ? [false, true] : [false])
            .ToLookup(candidate => meshes.Any(scene => candidate.For(scene)?.TrianglesTried(scene) > 0));
        var all = Ranking.Measured([.. isSlow[false]], CandidateRanking.Screening);
        var nearest = Ranking.Best(all[..(all.Count / 3)]);
        if (isSlow[true].Any() && !Ranking.IsCertain(nearest)) // tried only where no quick one explains the picture
        {
            all = Ranking.Sorted([.. all, .. Ranking.Measured([.. isSlow[true]], CandidateRanking.Screening)]);
            nearest = Ranking.Best(all[..(all.Count / 3)]);
        }
        if (!mayBeOtherSample)
        {
            var other = nearest.Where(single => single.Id != WrongProgram.Center.Id).Take(OtherSamples)
                .Select(single => single with { OtherSample = true });
            nearest = Ranking.Sorted([.. nearest, .. Ranking.Best([.. other])]);
        }
        if (!Ranking.IsCertain(nearest) && Ranking.IsDone(nearest, WorthVariants))
            nearest = Ranking.Sorted([.. nearest, .. Ranking.Best(InOtherVariants(nearest, Besides))]);
        return (nearest, all);
    }

    /// <summary>The small edits of the slides' formulas that explain the picture in which most is wrong.</summary>
    /// <param name="before">What is left unexplained by this program is to be explained; all that is wrong if null.</param>
    private List<WrongProgram> Edits(Unfinished way, WrongProgram? before = null)
    {
        var picture = pictures.MaxBy(picture => (double)picture.WrongCount / picture.PixelCount)!;
        if (before?.For(picture.Scene) is { } first) picture = new(picture, first);
        bool[] samples = MayBeOtherSample() ? [true, false] : [false];
        var found = samples.Select(otherSample => (otherSample, Edits: new EditSearch(picture, way, otherSample, budget).Find())).ToArray();
        if (way.NotYet.Count == 0)
            parts.AddRange(Measured(found.SelectMany(of => of.Edits.Others.Select(edits => (edits, of.otherSample))), onlyKnown: true));
        return Measured(found.SelectMany(of => of.Edits.Explaining.Select(edits => (edits, of.otherSample))), onlyKnown: false);

        List<WrongProgram> Measured(IEnumerable<(EditGroup Edits, bool OtherSample)> groups, bool onlyKnown) => Ranking.Measured(
        [
            .. from of in groups
               let mistake = EditNaming.Of(of.Edits)
               where mistake.Place is null ? known.Any(other => other.Id == mistake.Id) : !onlyKnown && possible?.Invoke(mistake) != false
               select new WrongProgram(way, [mistake], of.OtherSample),
        ], 1);
    }

    /// <summary>The ways to be unfinished that are nearest with one mistake in its usual variant.</summary>
    private IEnumerable<Unfinished> NearestWays(bool[] samples)
    {
        Unfinished[] ways = [.. Unfinished.ByColors(pictures, done)];
        if (ways.Length <= Ways) return ways;
        var candidates = from way in ways from mistake in known where MayShow(mistake, way) select new WrongProgram(way, [mistake], samples[0]);
        return Ranking.Measured([.. candidates], CandidateRanking.Screening).Select(candidate => candidate.Base).Distinct().Take(Ways);
    }

    /// <summary>The ranked candidates with some more, also with one of their mistakes in another variant; the best first.</summary>
    public List<WrongProgram> With(List<WrongProgram> candidates, List<WrongProgram> ranked) =>
        Ranking.Sorted([.. ranked, .. Ranking.Measured(candidates, 1), .. Ranking.Best(InOtherVariants(candidates, candidates.Count))]);

    /// <summary>Whether rays through the other sample point of each pixel explain so much alone that they are tried with every mistake.</summary>
    private bool MayBeOtherSample() =>
        Ranking.Measure(new(Unfinished.Nothing, [WrongProgram.Center], false), 0.05).Unexplained < 0.9 * Ranking.Wrong;

    /// <summary>A candidate, and before it the same with nothing missing: a shape may be misplaced by a second mistake, or clipping wrong.</summary>
    private static WrongProgram[] Written(WrongProgram candidate) =>
        candidate.Base.NotYet.Count > 0 ? [candidate with { Base = Unfinished.Nothing }, candidate] : [candidate];

    private List<WrongProgram> Singles(Unfinished way, bool[] samples) =>
    [
        .. from mistake in known
           where MayShow(mistake, way)
           from variant in mistake.Variants
           from otherSample in mistake == WrongProgram.Center ? (bool[])[false] : samples
           select new WrongProgram(way, [variant], otherSample),
    ];

    /// <summary>Whether the picture of a program that is unfinished in a way can show a mistake.</summary>
    private bool MayShow(Mistake mistake, Unfinished way) =>
        !way.AsMistakes.Contains(mistake) && mistake.Touches(kinds.Where(kind => !way.NotYet.Contains(kind)));

    /// <summary>Drops candidates with rays through the other sample point of each pixel that explain no more than these rays alone.</summary>
    private static List<WrongProgram> WithoutIdle(List<WrongProgram> singles)
    {
        if (singles.Find(candidate => candidate.Id == WrongProgram.Center.Id) is not { } alone) return singles;
        return [.. singles.Where(candidate => !candidate.OtherSample || candidate.Misfit.Unexplained < 0.9 * alone.Misfit.Unexplained)];
    }

    /// <summary>The best candidates with one of their mistakes in another variant; pairs also with rays through the other sample
    /// point of each pixel.</summary>
    private static List<WrongProgram> InOtherVariants(List<WrongProgram> candidates, int most) =>
    [
        .. from candidate in candidates.DistinctBy(candidate => candidate.Id).Take(most)
           from place in Enumerable.Range(0, candidate.Variants.Count)
           from variant in MistakeCatalog.Named(candidate.Variants[place].Id)?.Variants ?? []
           from otherSample in candidate.Variants.Count > 1 ? (bool[])[false, true] : [candidate.OtherSample]
           select candidate.With(place, variant) with { OtherSample = otherSample },
    ];
}
