namespace RayCaster.Teaching;

/// <summary>
/// What is wrong with a program, told from its pictures of several scenes together: first what it does not draw yet, then one mistake, then two.
/// A mistake that explains one picture but would show in another, where it is not to be seen, falls away; so twins of one scene fall apart.
/// </summary>
/// <remarks>
/// The loss of a hypothesis is the sum of what it leaves unexplained of each picture, at most 1 for each, so that one picture that nothing
/// explains does not hide what explains the others.
/// </remarks>
internal sealed class JointDiagnosis
{
    /// <summary>What share of the chosen pixels is looked at to sort out what is far off, and then more closely.</summary>
    private const double FirstLook = 1 / 30.0, SecondLook = 1 / 5.0;

    /// <summary>How many hypotheses get a second look, how many are looked at with all pixels, and how many are the base of further ones.</summary>
    private const int Second = 40, Last = 12, Bases = 8;

    /// <summary>With one thing more to be wrong the loss must fall below this share: more always explain a picture a little better.</summary>
    private const double Gain = 0.6;

    /// <summary>Losses that differ by less cannot be told apart.</summary>
    private const double Alike = 0.01;

    private readonly IReadOnlyList<ScenePicture> pictures;
    private readonly IReadOnlyList<Mistake> known;
    private double verdictLoss = double.PositiveInfinity;

    private JointDiagnosis(IReadOnlyList<ScenePicture> pictures, IReadOnlyList<Mistake> known)
    {
        // The most wrong picture first: it soonest tells what is far off.
        (this.pictures, this.known) = ([.. pictures.OrderByDescending(picture => picture.WrongShare)], known);
        if (pictures.All(picture => picture.IsRight)) return;
        TellsNothing = pictures.All(picture => picture.Picture.IsOneColor);
        if (!TellsNothing) Search();
        Unexplained = [.. pictures.Where(picture => !picture.IsRight && !picture.IsExplainedBy(Verdict))];
        var wrong = pictures.Count(picture => !picture.IsRight);
        if (2 * Unexplained.Count <= wrong) return;
        if (!TellsNothing) Nearest = Verdict;
        (Verdict, Alternatives) = (Hypothesis.Right, []);
        Unexplained = [.. pictures.Where(picture => !picture.IsRight)];
    }

    /// <summary>What is wrong; <see cref="Hypothesis.Right"/> if nothing is, or if nothing explains most of the wrong pictures.</summary>
    public Hypothesis Verdict { get; private set; } = Hypothesis.Right;

    /// <summary>What explains the pictures just as well, so that nothing tells it from the verdict.</summary>
    public IReadOnlyList<Hypothesis> Alternatives { get; private set; } = [];

    /// <summary>The wrong pictures that the verdict does not explain.</summary>
    public IReadOnlyList<ScenePicture> Unexplained { get; } = [];

    /// <summary>What comes nearest where nothing explains the pictures; null where something does.</summary>
    public Hypothesis? Nearest { get; }

    /// <summary>Whether all pictures are of one colour: many things make them so.</summary>
    public bool TellsNothing { get; }

    /// <summary>Diagnoses a program.</summary>
    /// <param name="pictures">Its pictures, at least one.</param>
    /// <param name="known">The mistakes to try.</param>
    public static JointDiagnosis Of(IReadOnlyList<ScenePicture> pictures, IReadOnlyList<Mistake> known) => new(pictures, known);

    /// <summary>The mistakes that can show in these scenes and do not take too long to try.</summary>
    public static IReadOnlyList<Mistake> KnownFor(IReadOnlyList<Scene> scenes) =>
    [
        .. MistakeCatalog.All.Where(mistake => !mistake.IsWithinRounding && scenes.Any(mistake.Touches)
            && scenes.All(scene => scene.Models.Count <= Lab.MostModels && new Lab(scene, mistake).TrianglesTried <= Lab.MostTriangles)),
    ];

    private void Search()
    {
        var unfinished = Best(UndoneParts.SubsetsFor(pictures.Select(picture => picture.Of.Scene)).Select(undone => new Hypothesis(undone, [])));
        Take(unfinished);
        if (IsEnough(Verdict)) return;

        // Behind a wrong camera all subsets look alike, so those that the order of the lab brings are tried in any case.
        var bases = unfinished.Take(Bases).Select(scored => scored.Hypothesis)
            .Concat(UndoneParts.InOrder.Select(undone => new Hypothesis(undone, [])));
        var singles = Best(bases.DistinctBy(hypothesis => hypothesis.Id).SelectMany(Extended));
        Take(singles);
        if (IsEnough(Verdict)) return;

        var second = singles.DistinctBy(scored => scored.Hypothesis.Id).Take(Bases).SelectMany(single =>
        {
            ScenePicture.Residue[] residues = [.. pictures.Select(picture => picture.Leave(single.Hypothesis))];
            return Extended(single.Hypothesis).Select(pair => new Scored(pair, Glance(pair, residues)));
        });
        Take(Closer([.. second.OrderBy(scored => scored.Loss).DistinctBy(scored => scored.Hypothesis.Id)]));
    }

    /// <summary>A hypothesis with one mistake more, in each wording that can still be seen.</summary>
    private IEnumerable<Hypothesis> Extended(Hypothesis hypothesis) =>
        from mistake in known
        where !hypothesis.Has(mistake.Id) && pictures.Any(picture => mistake.Touches(picture.Of.Scene.Without(hypothesis.Undone)))
        from wording in mistake.Wordings
        select hypothesis.With(wording);

    /// <summary>Makes the best of a list the verdict if it explains much more than the verdict of fewer mistakes.</summary>
    private void Take(List<Scored> ranked)
    {
        var best = ranked[0];
        if (best.Loss >= Gain * verdictLoss || !best.Hypothesis.Wordings.All(wording => Matters(best.Hypothesis, best.Hypothesis.Without(wording))))
            return;
        (Verdict, verdictLoss) = (WithoutNeedless(best.Hypothesis), best.Loss);
        Alternatives = [.. ranked.Where(other => other.Loss <= best.Loss + Alike && other.Hypothesis.Id != best.Hypothesis.Id)
            .Select(other => WithoutNeedless(other.Hypothesis)).Where(other => other.Id != Verdict.Id).DistinctBy(other => other.Id)];
    }

    /// <summary>Without the missing parts that no picture speaks for.</summary>
    private Hypothesis WithoutNeedless(Hypothesis hypothesis)
    {
        foreach (var part in Enum.GetValues<Undone>())
            if ((hypothesis.Undone & part) != 0 && hypothesis with { Undone = hypothesis.Undone & ~part } is var less && !Matters(hypothesis, less))
                hypothesis = less;
        return hypothesis;
    }

    /// <summary>
    /// Whether a picture shows the difference between a hypothesis and one that holds less to be wrong; beside another a mistake may change
    /// nothing.
    /// </summary>
    private bool Matters(Hypothesis more, Hypothesis less) =>
        pictures.Any(picture => picture.Unexplained(less) - picture.Unexplained(more) >= picture.Visible);

    private bool IsEnough(Hypothesis hypothesis) => pictures.All(picture => picture.Unexplained(hypothesis) <= picture.Visible);

    /// <summary>The best of many, sorted.</summary>
    private List<Scored> Best(IEnumerable<Hypothesis> hypotheses)
    {
        var list = new List<Scored>();
        var bound = double.PositiveInfinity; // what the worst of those that get a second look has lost
        var kept = new PriorityQueue<int, double>();
        foreach (var hypothesis in hypotheses)
        {
            var loss = Loss(hypothesis, FirstLook, bound);
            list.Add(new(hypothesis, loss));
            kept.Enqueue(0, -loss);
            if (kept.Count <= Second) continue;
            kept.Dequeue();
            kept.TryPeek(out _, out var worst);
            bound = -worst;
        }
        return Closer([.. list.OrderBy(scored => scored.Loss)]);
    }

    /// <summary>Looks closer at the best of a sorted list, and at the best of these with all pixels.</summary>
    private List<Scored> Closer(List<Scored> sorted)
    {
        foreach (var (count, share) in (ReadOnlySpan<(int, double)>)[(Second, SecondLook), (Last, 1)])
            sorted = [.. sorted.Take(count).Select(scored => scored with { Loss = Loss(scored.Hypothesis, share) }).OrderBy(scored => scored.Loss)];
        return sorted;
    }

    private double Loss(Hypothesis hypothesis, double share, double bound = double.PositiveInfinity)
    {
        var loss = 0.0;
        foreach (var picture in pictures)
        {
            loss += picture.Loss(picture.Unexplained(hypothesis, share));
            if (loss > bound) break;
        }
        return loss;
    }

    private double Glance(Hypothesis hypothesis, ScenePicture.Residue[] residues)
    {
        var loss = 0.0;
        for (var i = 0; i < pictures.Count; i++) loss += pictures[i].Loss(pictures[i].Unexplained(hypothesis, residues[i]));
        return loss;
    }

    private readonly record struct Scored(Hypothesis Hypothesis, double Loss);
}
