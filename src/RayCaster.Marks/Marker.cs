using System.Collections.Concurrent;

namespace RayCaster.Marks;

/// <summary>Gives points for pictures. Several threads may mark students at the same time.</summary>
internal sealed class Marker(Rubric rubric)
{
    /// <summary>What is wrong with pictures, by their hashes: the same pictures are diagnosed once.</summary>
    private readonly ConcurrentDictionary<string, Lazy<ProgramDiagnosis>> diagnoses = [];

    /// <summary>Judges the pictures of a student together.</summary>
    /// <param name="submitted">A picture of each scene of the rubric.</param>
    /// <param name="tests">The results of the tests by step; null if there are none.</param>
    /// <param name="onTests">What else must be known of the tests.</param>
    public StudentMarks Mark(string student, IReadOnlyList<SubmittedPicture> submitted,
        IReadOnlyDictionary<int, StepResult>? tests = null, params IReadOnlyList<string> onTests)
    {
        var isUntouched = submitted.All(picture => picture.IsUntouched);
        var marks = isUntouched ? Untouched(student, submitted) : ByPictures(student, submitted);
        var more = new List<string>();
        tests ??= new Dictionary<int, StepResult>();
        var areContradictory = tests.Values.All(step => step.IsPassed) && marks.Scenes.Any(scene => scene.Verdict == SceneVerdict.Unexplained);
        ItemMarks[] items =
        [
            .. rubric.Items.Zip(marks.Items, (item, pictures) =>
                item.Evidence == ItemEvidence.Pictures || areContradictory && item.Evidence == ItemEvidence.Both ? pictures
                    : WithTests(item, pictures, isUntouched, tests, more)),
        ];
        string[] look = [.. onTests, .. marks.LookYourself, .. more];
        var open = items.Where(item => item.Undecided > 0).Select(item => item.Name).ToArray();
        if (look.Length == 0 && open.Length > 0) look = [$"{string.Join(", ", open)}: neither pictures nor tests decide this"];
        return marks with { Items = items, OnTests = onTests, LookYourself = look };
    }

    private StudentMarks Untouched(string student, IReadOnlyList<SubmittedPicture> submitted) => new(
        student, [.. rubric.Items.Select(item => new ItemMarks(item.Name, item.Points, 0, 0, item.MissingParts))],
        [.. submitted.Select(picture => new SceneMarks(picture.Scene.Name, SceneVerdict.Explained))], [], [], [], [],
        ["all pictures are those of the hand-out before anything is written"]);

    private StudentMarks ByPictures(string student, IReadOnlyList<SubmittedPicture> submitted)
    {
        List<SubmittedPicture> pictures = [.. submitted.Where(picture => picture.CanBeJudged)];
        var diagnosis = diagnoses.GetOrAdd(string.Join(' ', pictures.Select(picture => $"{picture.Scene.Name}/{picture.Digest}")),
            _ => new(() => ProgramDiagnosis.Find([.. pictures.Select(picture => (picture.Scene.Diagnoser, picture.Picture!))], rubric.Known))).Value;
        var verdict = diagnosis.Verdict;
        return new(student, Items(diagnosis, pictures), [.. submitted.Select(picture => Verdict(picture, pictures.IndexOf(picture), diagnosis))],
            [.. MissingPart.All.Intersect(verdict.MissingParts)],
            [.. verdict.AllMistakes.Where(mistake => mistake.Place is null).Select(mistake => mistake.Id)],
            [.. verdict.Mistakes.Where(mistake => diagnosis.IsCertain && mistake.IsUsual).Select(mistake => mistake.Id)],
            [.. diagnosis.HidingMistakes.Select(mistake => mistake.Id)],
            [.. LookYourself(submitted, diagnosis, [.. diagnosis.Unexplained.Select(i => pictures[i].Scene.Name)])]);
    }

    /// <summary>An item's points by its pictures and the tests of its step.</summary>
    /// <param name="isUntouched">Whether the pictures show nothing, since the first steps draw none.</param>
    private static ItemMarks WithTests(RubricItem item, ItemMarks pictures, bool isUntouched,
        IReadOnlyDictionary<int, StepResult> all, List<string> lookYourself)
    {
        var tests = all.GetValueOrDefault(item.Step);
        var isFull = pictures.Points == item.Points;
        var isOpen = isUntouched || item.Evidence == ItemEvidence.Tests || pictures.Undecided > 0;
        var marks = pictures with { Tests = tests?.ToString() };
        if (tests?.IsConclusive(all) != true)
        {
            if (item.Evidence == ItemEvidence.Both) return marks;
            if (tests is { IsOpen: false }) lookYourself.Add($"{item.Name}: {tests}, but tests of an earlier step, which it uses, fail too");
            return marks with { Points = 0, Undecided = item.Points, Because = [] };
        }
        if (isOpen) return marks with { Points = tests.IsPassed ? item.Points : 0, Undecided = 0, Because = tests.IsPassed ? [] : pictures.Because };
        if (isFull == tests.IsPassed) return marks;
        lookYourself.Add($"{item.Name}: {tests}, but its pictures {(isFull ? "cost no points" : "cost points")}");
        return marks with { Points = 0, Undecided = item.Points };
    }

    /// <summary>The scenes whose pictures are right or explained. A mistake that shows in one of them and was not found was not made.</summary>
    private static List<MarkedScene> UnderstoodScenes(List<SubmittedPicture> pictures, ProgramDiagnosis diagnosis) =>
    [
        .. pictures.Select(picture => picture.Scene).Where((_, i) => !diagnosis.Unexplained.Contains(i)
            && (!diagnosis.IsGuess || !diagnosis.Wrong.Contains(i))),
    ];

    private List<ItemMarks> Items(ProgramDiagnosis diagnosis, List<SubmittedPicture> pictures)
    {
        var items = new List<ItemMarks>();
        var understood = UnderstoodScenes(pictures, diagnosis);
        var judged = pictures.ConvertAll(picture => picture.Scene);
        var isAllUnderstood = judged.Count == rubric.Scenes.Count && diagnosis.Unexplained.Count == 0;
        foreach (var item in rubric.Items)
        {
            var (lost, because) = Cost(item, diagnosis.Verdict);
            var least = lost;
            var most = lost;
            foreach (var alternative in diagnosis.Alternatives)
            {
                var (other, otherwise) = Cost(item, alternative);
                least = Math.Min(least, other);
                most = Math.Max(most, other);
                if (other != lost) because = [.. because.Union(otherwise)];
            }
            var mayBeAtFault = Concerns(diagnosis, item) || (diagnosis.IsOnlyLight ? !Decide(judged, item)
                : IsOutOfSight(item, diagnosis, pictures)
                    || !isAllUnderstood && (!Decide(understood, item) || (2 * understood.Count <= judged.Count && !IsOfShapes(item))));
            if (mayBeAtFault) most = item.Points;
            if (diagnosis.IsGuess) least = 0;
            items.Add(new(item.Name, item.Points, item.Points - most, most - least, because));
        }
        return items;
    }

    /// <summary>
    /// Whether some scenes decide an item as well as all scenes do: each of its mistakes and parts that shows in any scene shows in one of these.
    /// </summary>
    private bool Decide(List<MarkedScene> some, RubricItem item)
    {
        return some.Count > 0
            && item.Mistakes.All(mistake => ShowAsMuchAsAll(scene => scene.Shows(mistake)))
            && item.MissingParts.All(part => ShowAsMuchAsAll(scene => scene.Needs(part)));

        bool ShowAsMuchAsAll(Predicate<MarkedScene> shows) => some.Exists(shows) || !rubric.Scenes.Any(scene => shows(scene));
    }

    /// <summary>Whether an item is about formulas of shapes. A fault that no mistake explains may be in any of the others, unless most pictures
    /// are right: these use them too.</summary>
    private static bool IsOfShapes(RubricItem item) => item.MissingParts.Any(MissingPart.IsShape);

    /// <summary>Whether an item is about a shape that mistakes keep out of all pictures: it may be unwritten.</summary>
    private static bool IsOutOfSight(RubricItem item, ProgramDiagnosis diagnosis, List<SubmittedPicture> pictures) =>
        diagnosis.Verdict.Mistakes.Count > 0 && item.MissingParts.Where(MissingPart.IsShape).ToArray() is { Length: > 0 } kinds
            && kinds.Any(kind => pictures.Any(picture => picture.Scene.Needs(kind))) && !kinds.Any(diagnosis.Drawn.Contains);

    /// <summary>Whether what has no name, and costs nothing, may be in an item's formulas: it needs their shape, or has a mistake in them.</summary>
    private static bool Concerns(ProgramDiagnosis diagnosis, RubricItem item) =>
        item.MissingParts.Any(diagnosis.MayBeIn) || item.Mistakes.Any(mistake => diagnosis.MayBeIn(MistakeCatalog.Named(mistake)!));

    /// <summary>How many points an item loses if a program is the student's, and for which mistakes or missing parts.</summary>
    private (double Lost, string[] Because) Cost(RubricItem item, Suspect program)
    {
        string[] undone = [.. program.MissingParts.Intersect(item.MissingParts)];
        if (undone.Length > 0) return (item.Points, undone);
        string[] mistakes = [.. program.AllMistakes.Where(mistake => rubric.ItemOf(mistake) == item).Select(mistake => mistake.Id)];
        return (Math.Min(item.Points, item.Each * mistakes.Length), mistakes);
    }

    /// <param name="place">The picture's place among those that can be judged.</param>
    private static SceneMarks Verdict(SubmittedPicture picture, int place, ProgramDiagnosis diagnosis)
    {
        var verdict = !picture.CanBeJudged ? SceneVerdict.NoPicture
            : !diagnosis.Wrong.Contains(place) ? SceneVerdict.Right
            : diagnosis.Unexplained.Contains(place) ? SceneVerdict.Unexplained
            : SceneVerdict.Explained;
        var isDistinctive = verdict is SceneVerdict.Explained or SceneVerdict.Unexplained && !picture.Picture!.IsOneColor && !picture.IsUntouched;
        return new(picture.Scene.Name, verdict) { Digest = isDistinctive ? picture.Digest : null };
    }

    private IEnumerable<string> LookYourself(IReadOnlyList<SubmittedPicture> submitted, ProgramDiagnosis diagnosis, string[] ofWrong)
    {
        foreach (var group in submitted.Where(picture => !picture.CanBeJudged).GroupBy(picture => picture.Problem))
        {
            var isAll = group.Count() == submitted.Count && submitted.Count > 1;
            yield return $"{(isAll ? "all scenes" : string.Join(", ", group.Select(picture => picture.Scene.Name)))}: " +
                group.First().ProblemOf(several: group.Count() > 1);
        }
        string[][] repeated = [.. Repeated(submitted)];
        foreach (var scenes in repeated)
            yield return $"{string.Join(", ", scenes)}: the same picture of different scenes, so the program does not draw the scene yet";
        if (diagnosis.TellsNothing) yield return "all pictures are of one colour: many mistakes cause that";
        string[] unexplained = [.. ofWrong.Except(repeated.SelectMany(scenes => scenes))];
        SubmittedPicture[] judged = [.. submitted.Where(picture => picture.CanBeJudged)];
        foreach (var group in diagnosis.Causes.GroupBy(cause => cause.Value, cause => judged[cause.Key].Scene.Name))
            if (group.Intersect(unexplained).ToArray() is { Length: > 0 } scenes)
                yield return $"{string.Join(", ", scenes)}: {group.Key}";
        if (diagnosis.Causes.Count == 0 && !diagnosis.TellsNothing && unexplained.Length > 0)
            yield return $"{string.Join(", ", unexplained)}: " +
                (diagnosis.Note is { } note ? $"no known mistake explains this, but {note}"
                    : "no known mistake explains this" +
                        (diagnosis.Nearest is { } near ? $"; the nearest is {Names(near)}, which explains too little" : ""));
        foreach (var cause in diagnosis.Slips.Select(slip => slip.Cause).Distinct())
            yield return $"no known mistake explains the pictures, but a slip in {cause}";
        foreach (var other in diagnosis.Alternatives)
            if (rubric.Items.Any(item => Cost(item, other).Lost != Cost(item, diagnosis.Verdict).Lost))
                yield return $"these scenes cannot tell {Names(diagnosis.Verdict)} from {Names(other)}";
    }

    /// <summary>Scenes whose pictures are equal to the byte: the program does not draw the scene yet.</summary>
    private static IEnumerable<string[]> Repeated(IReadOnlyList<SubmittedPicture> submitted) =>
        from picture in submitted
        where picture.CanBeJudged && !picture.Picture!.IsOneColor
        group picture.Scene.Name by picture.Digest into same
        where same.Count() > 1
        select same.ToArray();

    private static string Names(Suspect program) => string.Join(" + ",
        program.MissingParts.Select(part => $"no {part}").Concat(program.AllMistakes.Select(mistake =>
            mistake.Place is null ? mistake.Id : $"a slip in {mistake.Cause}")));
}
