using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>The result of a diagnosis.</summary>
public enum Finding
{
    /// <summary>The picture is the scene's, but for rounding and single pixels on outlines.</summary>
    Matches,

    /// <summary>Some kinds of shape are not drawn yet, and what is drawn is right.</summary>
    Unfinished,

    /// <summary>One mistake of the catalogue, or two, explain the picture; some kinds of shape may be missing besides.</summary>
    Mistake,

    /// <summary>The picture is wrong, and no mistake of the catalogue explains it.</summary>
    NoneOfThese,

    /// <summary>Nothing but background, or models that are all black or all white: many mistakes draw such a picture, so none is named.</summary>
    TellsNothing,
}

/// <summary>One mistake, or two at once, that may have made a picture.</summary>
/// <param name="Mistakes">The mistakes, the one that explains more first, each in the wording that fits best.</param>
/// <param name="Unexplained">In about how many pixels the picture still differs by more than rounding.</param>
/// <param name="OtherSample">Whether its rays also pass through another place of each pixel than the scene says: centres for corners.</param>
/// <param name="Twins">Mistakes that draw the same picture of this scene.</param>
/// <param name="NotYet">What is also not drawn yet, as in <see cref="Diagnosis.NotYet"/>.</param>
/// <param name="SamePicture">Whether it draws the same picture of this scene as the first suspect; true of that one, too.</param>
/// <param name="HasSymptoms">Whether the picture certainly shows the mistakes' symptoms: each is in the wording that its symptom describes, and they
/// explain the picture.</param>
public sealed record Suspect(
    IReadOnlyList<Mistake> Mistakes, double Unexplained, bool OtherSample, IReadOnlyList<Mistake> Twins, IReadOnlyList<string> NotYet,
    bool SamePicture, bool HasSymptoms);

/// <summary>
/// Finds out why a picture is wrong: draws some of the scene's pixels as unfinished programs do, with each mistake of the catalogue, and with
/// pairs of them, and chooses the nearest.
/// </summary>
/// <remarks>
/// The picture of another program is never equal to the last bit: a channel may be off by two levels, and rays may pass through the pixels'
/// centres instead of their corners. The distance is the number of pixels that differ: small faults and other algebra disturb it less than a
/// mean of differences.
/// </remarks>
public sealed class Diagnosis
{
    /// <summary>In <see cref="NotYet"/>: models do not get darker with the distance.</summary>
    public const string Attenuation = "attenuation";

    /// <summary>In <see cref="NotYet"/>: zNear and zFar have no effect; only what lies behind the camera is left out.</summary>
    public const string Clipping = "clipping";

    /// <summary>What <see cref="NotYet"/> may hold: the kinds of shape as a scene file calls them, then the rest.</summary>
    public static IReadOnlyList<string> Parts { get; } = [.. ShapeKind.All.Select(kind => kind.Name), Attenuation, Clipping];

    /// <summary>How many pixels are drawn with each mistake, at most.</summary>
    private const int Pixels = 6000;

    /// <summary>A certain cause leaves at most this share of the wrong pixels unexplained.</summary>
    private const double Explained = 0.05;

    /// <summary>If an unfinished program leaves at most this share of the wrong pixels, the rest is right; more with rays through the other place of
    /// each pixel. If a mistake leaves more than the first share, other numbers of the scene are tried.</summary>
    private const double Nearly = 0.001, NearlyOtherSample = 0.01;

    /// <summary>A mistake that leaves a greater share of the wrong pixels fits only by chance; several mistakes may leave less, but more if they
    /// leave at most a third of what one leaves. A mistake whose pixels may lie anywhere leaves more.</summary>
    private const double Foreign = 0.1, ForeignPair = 0.05, ForeignApart = 0.08, Third = 1 / 3.0, Scattered = 0.18;

    /// <summary>Another number of the scene is named in place of one mistake, or of two, if it leaves less than this share of what they leave.
    /// </summary>
    private const double NumberForOne = 0.25, NumberForPair = 0.8;

    /// <summary>Mistakes are named in place of missing shapes or a missing model if they leave at most this share of what these leave.</summary>
    private const double Much = 0.25;

    /// <summary>A mistake is mentioned at all if it leaves at most this share of the wrong pixels; two mistakes may leave less.</summary>
    private const double Mentioned = 0.8, MentionedPair = 0.4;

    /// <summary>How many of the nearest mistakes are mentioned if none explains the picture.</summary>
    private const int Shown = 3;

    /// <summary>How many of the best are examined, of which at most five are named.</summary>
    private const int Looked = 12;

    /// <summary>In larger scenes no models are left out one by one to find a missing one.</summary>
    private const int MostMissing = 32;

    private readonly SceneDiagnosis prepared;
    private readonly Evidence evidence;
    private readonly Predicate<Mistake>? likely;
    private double leftByMissingModel, leftByOne;

    internal Diagnosis(SceneDiagnosis prepared, Picture picture, IReadOnlyCollection<string> done, Predicate<Mistake>? likely)
    {
        (this.prepared, this.likely) = (prepared, likely);
        var (scene, right) = (prepared.Scene, prepared.Right);
        evidence = new(scene, right, picture, Pixels, !TooManyModels);
        if (evidence.WrongCount < evidence.OutlineCount && evidence.OutlineCount > SceneFitness.LeastPixels)
        {
            var strict = new Evidence(scene, right, picture, Pixels, forgiveOutlines: false);
            if (prepared.Known.Any(mistake => IsAll(mistake, strict))) evidence = strict;
        }
        if (WrongCount == 0 || (TooManyModels && evidence.IsOnlyOutlines))
        {
            Finding = Finding.Matches;
            return;
        }
        var plain = PlainPicture.Says(scene, picture, right);
        if (plain is not null && (TooManyModels || !PlainPicture.IsOneShade(scene, picture)))
        {
            (Finding, Likely) = (Finding.TellsNothing, [plain]);
            return;
        }
        Finding = Finding.NoneOfThese;
        if (TooManyModels) return;

        MissingModel = FindMissingModel();
        Answer(new([evidence], prepared.Known, done, prepared.Threads, likely), done);
        if (plain is null) return;
        Suspects = [.. Suspects.Where(suspect => suspect is { Mistakes.Count: 1, NotYet.Count: 0 })]; // several would explain one colour by chance
        if (Suspects.Count == 0) (Finding, NotYet, Likely, Nearest) = (Finding.TellsNothing, [], [plain], []);
    }

    /// <summary>Whether the scene has too many models for its mistakes to be tried.</summary>
    public bool TooManyModels => prepared.TooManyModels;

    /// <summary>Mistakes that would take too long to try, because the scene has too many triangles.</summary>
    public IReadOnlyList<Mistake> NotTried => prepared.NotTried;

    /// <summary>
    /// What the program does not do yet, as far as the picture shows: kinds of shape by their names in scene files, "attenuation", "clipping". With
    /// <see cref="Finding.Unfinished"/> everything else is right; otherwise there are also mistakes.
    /// </summary>
    public IReadOnlyList<string> NotYet { get; private set; } = [];

    /// <summary>The kind of difference, if no mistake explains it: sentences, the most informative first.</summary>
    public IReadOnlyList<string> Likely { get; private set; } = [];

    /// <summary>The name of the model without which the scene gives the picture; null if there is none.</summary>
    public string? MissingModel { get; }

    /// <summary>Whether the scene's own picture is of one colour, so that a picture that matches says little.</summary>
    public bool ProvesNothing => prepared.Right.IsOneColor;

    /// <summary>The result.</summary>
    public Finding Finding { get; private set; }

    /// <summary>Which mistakes may have made the picture, the most likely first.</summary>
    public IReadOnlyList<Suspect> Suspects { get; private set; } = [];

    /// <summary>If nothing explains the picture, the nearest mistakes, the one that explains most first.</summary>
    public IReadOnlyList<Suspect> Nearest { get; private set; } = [];

    /// <summary>How many pixels the picture has.</summary>
    public int PixelCount => evidence.PixelCount;

    /// <summary>In how many pixels it differs from the scene's picture by more than rounding.</summary>
    public int WrongCount => evidence.WrongCount;

    /// <summary>In how many pixels more it shows what the scene shows a thousandth of a pixel away, where the last bits decide.</summary>
    public int OutlineCount => evidence.OutlineCount;

    /// <summary>The share of pixels that are right but for a channel that is one level darker: rounding instead of truncating.</summary>
    public double DarkerShare => evidence.DarkerShare;

    /// <summary>Diagnoses a picture; for many of one scene see <see cref="SceneDiagnosis"/>.</summary>
    /// <param name="scene">The scene that it should show, at the picture's size.</param>
    /// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    public static Diagnosis Of(Scene scene, Picture picture) => new SceneDiagnosis(scene).Judge(picture);

    private void Answer(DiagnosisSearch search, IReadOnlyCollection<string> done)
    {
        var (ranked, picture) = (search.Run(), evidence.Picture);
        leftByOne = ranked.Where(IsOne).Select(trial => trial.Misfit.Unexplained).DefaultIfEmpty(0).Min();
        var best = ranked.Find(trial => trial.Misfit.Unexplained <= MayLeave(trial) * WrongCount) ?? ranked[0];
        if (best.Base.Kinds.Any() && best.Misfit.Unexplained > Nearly * WrongCount) // few wrong pixels may be all that shows of a misplaced shape
            best = ranked.Find(trial => !trial.Base.Kinds.Any() && trial.Misfit.Unexplained <= Much * best.Misfit.Unexplained) ?? best;
        best = search.Ranking.WithoutIdle(best);
        var left = best.Misfit.Unexplained / WrongCount;
        // where one missing model is enough, two mistakes are not assumed
        var isNamed = MissingModel is null ? left <= Math.Max(Explained, MayLeave(best))
            : left <= Explained && (best.Wordings.Count < 2 || best.Misfit.Unexplained < Much * leftByMissingModel);
        var isCertain = false;
        // Two mistakes of the camera may make the picture of another angle of view, or by chance nearly so: the more exact of both is named.
        var isOfCamera = best.Named.Count > 1 && best.Named.All(mistake => mistake.Concerns == Concerns.Camera);
        if ((left > Nearly || isOfCamera) && MissingModel is null && !evidence.IsOnlyOutlines && SameSize(picture))
        {
            var byModels = SceneDifference.Find(prepared.Scene, new(picture, prepared.Right), prepared.Threads);
            var most = best.Misfit * (best.Named.Count < 2 ? NumberForOne : isOfCamera ? 1 : NumberForPair);
            var (misfit, certain) = LikelyCause.Certain(prepared, byModels, evidence);
            if (certain is not null && misfit.CompareTo(most) < 0) (isNamed, isCertain, Likely) = (false, true, [certain]);
            else if (!isNamed) Likely = [.. LikelyCause.Hints(byModels, evidence)];
            else if (certain is not null && misfit.Unexplained <= TrialRanking.Idle * WrongCount) Likely = [certain];
        }
        if (!isNamed)
        {
            if (evidence.IsOnlyOutlines) Finding = Finding.Matches;
            if (evidence.IsOnlyOutlines || MissingModel is not null) return;
            if (Likely.Count == 0 && LikelyCause.OfTheWhole(evidence) is { } whole) Likely = [whole];
            if (!isCertain) Nearest = [.. NearestOf(ranked, best.Draw(prepared.Scene))];
            return;
        }
        NotYet = best.Base.NotYet;
        if (best.Wordings.Count == 0 && best.Base.Kinds.Any() && left > (best.OtherSample ? NearlyOtherSample : Nearly)
            && !IsRestRight([.. best.Base.Kinds], picture, done)) return;
        Finding = best.Named.Count > 0 ? Finding.Mistake : Finding.Unfinished;
        var named = ranked.Where(trial => trial.Named.Count > 0 && trial.Misfit.Unexplained <= MayLeave(trial) * WrongCount)
            .DistinctBy(trial => trial.Id).Take(Looked).Select(search.Ranking.WithoutIdle).Prepend(best).Where(trial => trial.Named.Count > 0);
        if (Finding == Finding.Unfinished) // what may have lost those shapes, if they are written already
            named = named.Where(trial => trial.Base.NotYet.Count == 0 && trial.Misfit.Unexplained <= best.Misfit.Unexplained + 0.005 * WrongCount);
        else if (best.Base.Kinds.Any()) named = named.Take(1);
        if (best.Base.Kinds.Any()) named = named.Concat(Losing(best));
        WrongProgram[] first = [.. named.DistinctBy(trial => IdsOf(trial.Named)).Take(5)];
        var likeliest = first.Length > 0 ? first[0].Draw(prepared.Scene) : null;
        Suspects =
        [
            .. first.Take(1).Concat(first.Skip(1).OrderBy(trial => trial.Misfit.Unexplained)).Select(trial => AsSuspect(trial, likeliest!))
                .DistinctBy(suspect => IdsOf(suspect.Mistakes)),
        ];
    }

    private IEnumerable<Suspect> NearestOf(List<WrongProgram> ranked, Lab likeliest) => ranked
        .Where(trial => trial.Wordings.Count > 0 && trial.Misfit.Unexplained < (trial.Wordings.Count > 1 ? MentionedPair : Mentioned) * WrongCount)
        .DistinctBy(trial => IdsOf(trial.Wordings)).Take(Shown)
        .OrderBy(trial => trial.Misfit.Unexplained).Select(trial => AsSuspect(trial, likeliest));

    /// <summary>The same for mistakes in another order, or in other wordings.</summary>
    private static string IdsOf(IEnumerable<Mistake> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());

    private double MayLeave(WrongProgram trial) => trial.Wordings is [{ Id: "tri-area" }] ? Scattered
        : IsOne(trial) ? Foreign : trial.Misfit.Unexplained <= Third * leftByOne ? ForeignApart : ForeignPair;

    private static bool IsOne(WrongProgram trial) => trial.Wordings.Count + trial.Base.Kinds.Count() < 2;

    /// <summary>The mistakes that would also make a program lose the missing shapes.</summary>
    private IEnumerable<WrongProgram> Losing(WrongProgram best)
    {
        var without = evidence.Draw(best.Draw(prepared.Scene));
        var rest = new Unfinished([.. best.Base.NotYet.Except(best.Base.Kinds)]);
        return from mistake in prepared.Known
               where best.Base.Kinds.All(kind => (mistake.Concerns & Mistake.KindOf(kind)) != 0)
               let trial = mistake.Wordings.Select(wording => best with { Base = rest, Wordings = [.. best.Wordings, wording] })
                   .FirstOrDefault(trial => evidence.AreAlike(without, trial.Draw(prepared.Scene)))
               where trial is not null
               orderby trial.Wordings[^1] != mistake, BitOperations.PopCount((uint)mistake.Concerns) // the commonest, then those of few shapes
               select trial;
    }

    /// <summary>Whether the rest is right. Beside missing shapes a small mistake counts for little, so the rest is judged by itself.</summary>
    private bool IsRestRight(string[] kinds, Picture picture, IReadOnlyCollection<string> done)
    {
        var drawn = new Unfinished(kinds).PartOf(prepared.Scene);
        var rest = new SceneDiagnosis(drawn, prepared.Threads, prepared.Possible).Judge(picture, done, likely);
        if (rest.Finding == Finding.Matches) return true;
        NotYet = [.. kinds, .. rest.NotYet];
        (Finding, Suspects, Likely) = (rest.Finding, rest.Suspects, rest.Likely);
        return false;
    }

    private bool SameSize(Picture picture) => (picture.Width, picture.Height) == (prepared.Right.Width, prepared.Right.Height);

    private string? FindMissingModel()
    {
        if (prepared.Scene.Models.Count > MostMissing) return null;
        for (var i = 0; i < prepared.Scene.Models.Count; i++)
        {
            var without = new Lab(prepared.Scene with { Models = [.. prepared.Scene.Models.Where((_, place) => place != i)] });
            if (!Explains(without, 0.1) || !Explains(without, 1)) continue;
            leftByMissingModel = evidence.Misfit(without).Unexplained;
            return ModelName.Of(prepared.Scene, i);
        }
        return null;

        bool Explains(Lab lab, double share) => evidence.Misfit(lab, share).Unexplained <= Explained * WrongCount;
    }

    /// <summary>
    /// Whether a mistake is all that is wrong, outlines too: a box that loses its edge to 0 · ∞ is not forgiven. A mistake of the camera may by
    /// chance be the last bits of another program.
    /// </summary>
    private bool IsAll(Mistake mistake, Evidence strict) => (mistake.Concerns & Concerns.Camera) == 0
        && mistake.Wordings.Any(wording => ((double[])[0.1, 1]).All(share =>
            strict.Misfit(new Lab(prepared.Scene, wording), share).Unexplained <= Foreign * strict.WrongCount));

    private Suspect AsSuspect(WrongProgram trial, Lab likeliest)
    {
        Mistake[] twins = [];
        var own = trial.Draw(prepared.Scene);
        var drawn = evidence.Draw(own);
        var shown = Visible(trial, drawn);
        if (shown is [var named] && !own.Scatters)
        {
            var way = trial.Wordings.Count > 0 ? trial.Base : Unfinished.Nothing;
            twins = [.. prepared.Known.AsParallel().AsOrdered().WithDegreeOfParallelism(prepared.Threads ?? Environment.ProcessorCount)
                .Where(other => other.Id != named.Id && other.Wordings.Any(
                    wording => evidence.AreAlike(drawn, new WrongProgram(way, [wording], trial.OtherSample).Draw(prepared.Scene))))];
        }
        var isSame = own.Scatters == likeliest.Scatters && evidence.AreAlike(drawn, likeliest);
        var isTypical = trial.Misfit.Unexplained <= Explained * WrongCount && trial.Unusual == 0;
        return new(shown, trial.Misfit.Unexplained, trial.OtherSample, twins, trial.Base.NotYet, isSame, isTypical);
    }

    /// <summary>A program's mistakes, but for one of zNear and zFar that are not written yet, if the picture does not show it.</summary>
    private Mistake[] Visible(WrongProgram trial, Evidence.Drawn drawn)
    {
        var hidden = trial.Named.Except(trial.Wordings).FirstOrDefault(part => trial.Named.Count > 1 && evidence.AreAlike(drawn,
            new(prepared.Scene, [.. trial.Named.Where(other => other != part), .. trial.Mistakes.Except(trial.Wordings)])));
        return [.. trial.Named.Where(mistake => mistake != hidden)];
    }
}
