namespace RayCaster.Teaching;

/// <summary>
/// Finds what is wrong with a program from its pictures of several scenes together: what it does not draw yet, then one mistake, then two.
/// A mistake that explains one picture, but would show in another picture that is right, drops out. So several scenes tell mistakes apart that
/// look the same in one of them.
/// </summary>
/// <remarks>
/// The loss of a program is the sum of what it leaves unexplained in each picture, at most 1 for each picture. One picture that nothing explains
/// therefore does not hide what explains the others.
/// </remarks>
internal sealed class JointDiagnosis
{
    /// <summary>The share of the chosen pixels that the first look takes, and the second.</summary>
    private const double FirstLook = 1 / 30.0, SecondLook = 1 / 5.0;

    /// <summary>How many programs get a second look, and how many of these a look at all chosen pixels.</summary>
    private const int Second = 40, Last = 12;

    /// <summary>How many of the best programs get one more mistake.</summary>
    private const int Bases = 8;

    /// <summary>How many pictures are diagnosed by themselves.</summary>
    private const int Consulted = 2;

    /// <summary>One more mistake must reduce the loss to less than this share: more mistakes always explain a picture a little better.</summary>
    private const double Gain = 0.6;

    /// <summary>A verdict that changes a picture must not leave a greater share of its wrong pixels unexplained.</summary>
    private const double Helpless = 0.5;

    /// <summary>A program is near the pictures if its loss is less than this share of the loss of a right program.</summary>
    private const double Near = 0.8;

    /// <summary>If one kind of shape has a greater share of the pixels in the wrong light, its formula may be the reason.</summary>
    private const double OneKind = 0.9;

    /// <summary>Losses that differ by less are taken as equal.</summary>
    private const double Alike = 0.01;

    private static readonly WrongProgram right = new(Unfinished.Nothing, [], false);

    private readonly IReadOnlyList<ScenePicture> pictures;
    private readonly IReadOnlyList<Mistake> known;
    private double verdictLoss = double.PositiveInfinity;

    private JointDiagnosis(IReadOnlyList<ScenePicture> pictures, IReadOnlyList<Mistake> known)
    {
        // The picture with the most wrong pixels comes first: it is the quickest to rule programs out.
        (this.pictures, this.known) = ([.. pictures.OrderByDescending(picture => picture.WrongShare)], known);
        if (pictures.All(picture => picture.IsRight)) return;
        TellsNothing = pictures.All(picture => picture.Picture.IsOneColor);
        if (!TellsNothing) Search();
        Unexplained = [.. pictures.Where(picture => !picture.IsRight && !picture.IsExplainedBy(Verdict))];
        var wrong = pictures.Count(picture => !picture.IsRight);
        if (2 * Unexplained.Count <= wrong)
        {
            IsGuess = Unexplained.Any(IsHardlyExplained);
            return;
        }
        if (verdictLoss < Near * wrong) Nearest = Verdict;
        (Verdict, Alternatives) = (right, []);
        Unexplained = [.. pictures.Where(picture => !picture.IsRight)];
        IsOnlyLight = !TellsNothing && IsLightOfAll();
    }

    /// <summary>What is wrong; a right program if nothing is wrong, or if nothing explains most of the wrong pictures.</summary>
    public WrongProgram Verdict { get; private set; } = right;

    /// <summary>Other programs that explain the pictures as well as the verdict.</summary>
    public IReadOnlyList<WrongProgram> Alternatives { get; private set; } = [];

    /// <summary>The wrong pictures that the verdict does not explain.</summary>
    public IReadOnlyList<ScenePicture> Unexplained { get; } = [];

    /// <summary>Whether the verdict changes a picture and leaves more than half of its wrong pixels unexplained. Then it is only a guess in the
    /// other pictures, too.</summary>
    public bool IsGuess { get; }

    /// <summary>The program that comes nearest where none explains the pictures; null where one does.</summary>
    public WrongProgram? Nearest { get; }

    /// <summary>
    /// Whether nothing explains the pictures, but all outlines are right. The light is wrong on more than one kind of shape, so no formula of a
    /// shape is the reason.
    /// </summary>
    public bool IsOnlyLight { get; }

    /// <summary>Whether each picture is of one colour: many mistakes cause that.</summary>
    public bool TellsNothing { get; }

    /// <summary>Diagnoses a program.</summary>
    /// <param name="pictures">Its pictures, at least one.</param>
    public static JointDiagnosis Of(IReadOnlyList<ScenePicture> pictures, IReadOnlyList<Mistake> known) => new(pictures, known);

    /// <summary>Whether the verdict changes a picture, and leaves more than half of its wrong pixels unexplained.</summary>
    private bool IsHardlyExplained(ScenePicture picture)
    {
        var (left, all) = (picture.Unexplained(Verdict), picture.Unexplained(right));
        return left != all && left > Helpless * all;
    }

    private bool IsLightOfAll()
    {
        var kinds = Unexplained.Select(picture => picture.InAnotherLight()).TakeWhile(kinds => kinds.Count > 0).ToList();
        var counts = kinds.SelectMany(kinds => kinds).GroupBy(kind => kind.Key, kind => kind.Value).Select(kind => kind.Sum()).ToList();
        return kinds.Count == Unexplained.Count && counts.Max() < OneKind * counts.Sum();
    }

    private void Search()
    {
        var unfinished = Best(Unfinished.Ways(pictures.SelectMany(picture => picture.Of.Scene.Models), []).Prepend(Unfinished.Nothing)
            .Select(way => new WrongProgram(way, [], false)));
        Take(unfinished);
        if (IsEnough(Verdict)) return;

        // Behind a wrong camera all ways to be unfinished look alike, so those in the order of the lab are tried in any case.
        var bases = unfinished.Take(Bases).Select(scored => scored.Program).Concat(Unfinished.InOrder.Select(way => right with { Base = way }))
            .Append(right);
        var singles = Best(bases.DistinctBy(program => program.Id).SelectMany(Extended));
        Take(singles);
        if (IsEnough(Verdict)) return;

        var pairs = singles.DistinctBy(scored => scored.Program.Id).Take(Bases).SelectMany(single =>
        {
            var residues = pictures.ToDictionary(picture => picture, picture => picture.Leave(single.Program));
            return Extended(single.Program).Select(pair =>
                new Scored(pair, pictures.Sum(picture => picture.Loss(picture.Unexplained(pair, residues[picture])))));
        });
        var ranked = Closer([.. pairs.OrderBy(scored => scored.Loss).DistinctBy(scored => scored.Program.Id)]);
        if (!IsEnough(ranked[0].Program)) ranked = [.. ranked.Concat(Best(NamedForOnePicture())).OrderBy(scored => scored.Loss)];
        Take(ranked);
    }

    /// <summary>
    /// What a diagnosis of single pictures names, in each wording. It tries all pairs of mistakes that change a whole picture: neither of two such
    /// is near by itself.
    /// </summary>
    private IEnumerable<WrongProgram> NamedForOnePicture() =>
        from picture in pictures.Where(picture => !picture.IsRight).Take(Consulted)
        from suspect in picture.Of.Judge.Judge(picture.Picture).Suspects
        let way = new Unfinished(suspect.NotYet)
        from program in suspect.Mistakes.Intersect(known).Except(way.AsMistakes).Aggregate(
            (IEnumerable<WrongProgram>)[new(way, [], suspect.OtherSample)],
            (programs, mistake) => programs.SelectMany(program =>
                mistake.Wordings.Select(wording => program with { Wordings = [.. program.Wordings, wording] })))
        select program;

    /// <summary>A program with one mistake more, in each wording that can still be seen.</summary>
    private IEnumerable<WrongProgram> Extended(WrongProgram program)
    {
        var models = pictures.SelectMany(picture => picture.Of.Scene.Models);
        string[] drawn = [.. models.Select(model => model.Kind).Distinct().Except(program.Base.NotYet)];
        return from mistake in known
               where mistake.Touches(drawn) && !program.Wordings.Any(wording => wording.Id == mistake.Id)
               from wording in mistake.Wordings
               select program with { Wordings = [.. program.Wordings, wording] };
    }

    /// <summary>Makes the best of a list the verdict if it explains much more than the verdict with fewer mistakes.</summary>
    private void Take(List<Scored> ranked)
    {
        var (best, loss) = ranked[0];
        if (loss >= Gain * verdictLoss) return;
        if (best.Wordings.Any(wording => !Matters(best, best with { Wordings = [.. best.Wordings.Except([wording])] }))) return;
        (Verdict, verdictLoss) = (WithoutNeedless(best), loss);
        Alternatives = [.. ranked.Where(other => other.Loss <= loss + Alike && other.Program.Id != best.Id)
            .Select(other => WithoutNeedless(other.Program)).Where(other => other.Id != Verdict.Id).DistinctBy(other => other.Id)];
    }

    /// <summary>Without the missing parts that change no picture.</summary>
    private WrongProgram WithoutNeedless(WrongProgram program)
    {
        foreach (var part in program.Base.NotYet)
            if (program with { Base = new([.. program.Base.NotYet.Except([part])]) } is var less && !Matters(program, less)) program = less;
        return program;
    }

    /// <summary>Whether a picture shows the difference between a program and one with less wrong: beside another mistake, one may change
    /// nothing.</summary>
    private bool Matters(WrongProgram more, WrongProgram less) =>
        pictures.Any(picture => picture.Unexplained(less) - picture.Unexplained(more) >= picture.Visible);

    private bool IsEnough(WrongProgram program) => pictures.All(picture => picture.Unexplained(program) <= picture.Visible);

    /// <summary>The best of many, sorted.</summary>
    private List<Scored> Best(IEnumerable<WrongProgram> programs)
    {
        var list = new List<Scored>();
        var best = new PriorityQueue<double, double>(); // the losses of the programs that get a second look, the greatest first
        foreach (var program in programs)
        {
            var loss = Loss(program, FirstLook, best.Count == Second ? best.Peek() : double.PositiveInfinity);
            list.Add(new(program, loss));
            best.Enqueue(loss, -loss);
            if (best.Count > Second) best.Dequeue();
        }
        return Closer([.. list.OrderBy(scored => scored.Loss)]);
    }

    /// <summary>Looks closer at the best of a sorted list, and at all pixels of the best of these.</summary>
    private List<Scored> Closer(List<Scored> sorted)
    {
        foreach (var (count, share) in (ReadOnlySpan<(int, double)>)[(Second, SecondLook), (Last, 1)])
            sorted = [.. sorted.Take(count).Select(scored => scored with { Loss = Loss(scored.Program, share) })
                .OrderBy(scored => scored.Loss).ThenBy(scored => scored.Program.Unusual)];
        return sorted;
    }

    /// <summary>The loss of a program; once it exceeds a bound, only that it does.</summary>
    private double Loss(WrongProgram program, double share, double bound = double.PositiveInfinity)
    {
        var loss = 0.0;
        foreach (var picture in pictures)
        {
            loss += picture.Loss(picture.Unexplained(program, share));
            if (loss > bound) break;
        }
        return loss;
    }

    private readonly record struct Scored(WrongProgram Program, double Loss);
}
