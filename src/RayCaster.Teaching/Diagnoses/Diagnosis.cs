namespace RayCaster.Teaching;

/// <summary>What a diagnosis comes to.</summary>
public enum Finding
{
    /// <summary>The picture is the scene's, but for rounding and single pixels on outlines.</summary>
    Matches,

    /// <summary>One mistake of the catalogue, or two, explain the picture.</summary>
    Mistake,

    /// <summary>The picture is wrong, and no mistake of the catalogue explains it.</summary>
    NoneOfThese,
}

/// <summary>One mistake, or two at once, that may have made a picture.</summary>
/// <param name="Mistakes">The mistakes, the one that explains more first.</param>
/// <param name="Unexplained">In about how many pixels the picture looks otherwise nevertheless, by more than rounding.</param>
/// <param name="OtherSample">Whether the picture is also sampled at the other place in its pixels than the scene says: centres for corners.</param>
/// <param name="Twins">Mistakes that give the same picture of this scene, so that nothing can tell them apart.</param>
public sealed record Suspect(IReadOnlyList<Mistake> Mistakes, double Unexplained, bool OtherSample, IReadOnlyList<Mistake> Twins);

/// <summary>
/// Finds out which mistake makes a picture: draws some of the scene's pixels with each mistake of the catalogue, and with pairs of them,
/// and sees which comes nearest.
/// </summary>
/// <remarks>
/// A picture of somebody else's program never agrees to the last bit: a channel may be off by two levels, and the pixels may be sampled
/// at their centres instead of their corners. Nearness is the number of pixels that look otherwise, which small faults and
/// foreign algebra survive better than a mean of differences.
/// </remarks>
public sealed class Diagnosis
{
    /// <summary>How many pixels are drawn with each mistake, at most.</summary>
    private const int Pixels = 6000;

    /// <summary>What share of these tells whether a mistake is worth a closer look.</summary>
    private const double FirstLook = 0.1;

    /// <summary>How many mistakes, or pairs of mistakes, get the closer look.</summary>
    private const int Closer = 24;

    /// <summary>How many single mistakes are tried together with every other.</summary>
    private const int Partners = 10;

    /// <summary>What a mistake may leave unexplained, as a share of the wrong pixels, for the search to end.</summary>
    private const double Explained = 0.05;

    /// <summary>Two mistakes must leave less than this share of what one leaves: two explain any picture better than one.</summary>
    private const double PairGain = 0.6;

    /// <summary>The share of the wrong pixels that the nearest mistake may leave before it is taken for chance.</summary>
    private const double Foreign = 0.5;

    /// <summary>The share of the wrong pixels that a mistake may leave to be mentioned at all.</summary>
    private const double Idle = 0.8;

    /// <summary>As many models are left out, one at a time, to see whether one is missing.</summary>
    private const int MostMissing = 32;

    private static readonly Mistake center = MistakeCatalog.Named("center")!;

    private readonly Scene scene;
    private readonly Evidence evidence;
    private readonly Mistake[] known; // those that can show in this scene at all
    private readonly int? threads;

    private Diagnosis(Scene scene, Picture picture, int? threads)
    {
        (this.scene, this.threads) = (scene, threads);
        var possible = MistakeCatalog.All.Where(mistake => mistake.Touches(scene) && !mistake.IsWithinRounding).ToArray();
        known = [.. possible.Where(mistake => new Lab(scene, mistake).TrianglesTried <= Lab.MostTriangles)];
        NotTried = [.. possible.Except(known)];
        TooManyModels = scene.Models.Count > Lab.MostModels;
        var right = Renderer.Render(scene, threads);
        var most = Math.Clamp(Pixels * 500L / Math.Max(1, scene.Models.Count), 300, Pixels); // the time stays
        evidence = new(scene, right, picture, (int)most, !TooManyModels);
        if (evidence.WrongCount < evidence.OutlineCount && evidence.OutlineCount > SceneFitness.LeastPixels)
        {
            var strict = new Evidence(scene, right, picture, (int)most, forgiveOutlines: false);
            if (known.Any(mistake => IsAll(mistake, strict))) evidence = strict;
        }
        ProvesNothing = right.IsOneColor;
        PixelCount = evidence.PixelCount;
        WrongCount = evidence.WrongCount;
        OutlineCount = evidence.OutlineCount;
        DarkerShare = evidence.DarkerShare;
        if (WrongCount == 0)
        {
            Finding = Finding.Matches;
            return;
        }

        if (TooManyModels)
        {
            Finding = evidence.IsOnlyOutlines ? Finding.Matches : Finding.NoneOfThese;
            return;
        }

        MissingModel = FindMissingModel();
        var singles = WithoutIdle(Best(Singles()));
        var single = singles[0];
        var ranked = singles;
        if (MissingModel is null && single.Misfit.Unexplained > Explained * WrongCount && Best(Pairs(singles)) is [var pair, ..]
            && pair.Misfit.Unexplained < PairGain * single.Misfit.Unexplained)
            ranked = [pair, .. singles];
        var left = ranked[0].Misfit.Unexplained / WrongCount;
        Finding = evidence.IsOnlyOutlines && left > Foreign ? Finding.Matches
            : left > Foreign ? Finding.NoneOfThese
            : Finding.Mistake;
        if (Finding == Finding.Mistake) Suspects = [.. Distinct(ranked).Take(5).Select(AsSuspect)];
        if (Finding == Finding.NoneOfThese && left < Idle) Nearest = AsSuspect(ranked[0]);
    }

    /// <summary>The model without which the scene gives the picture, as texts call it; null where none does.</summary>
    public string? MissingModel { get; }

    /// <summary>Whether the scene has too many models for its mistakes to be tried.</summary>
    public bool TooManyModels { get; }

    /// <summary>Whether the scene's own picture is of one colour, so that a picture that matches says little.</summary>
    public bool ProvesNothing { get; }

    /// <summary>What it comes to.</summary>
    public Finding Finding { get; }

    /// <summary>What may have made the picture, the most likely first.</summary>
    public IReadOnlyList<Suspect> Suspects { get; } = [];

    /// <summary>The nearest of what did not make the picture, where none of these did.</summary>
    public Suspect? Nearest { get; }

    /// <summary>What might be in the picture but takes too long to try: the scene has too many triangles for it.</summary>
    public IReadOnlyList<Mistake> NotTried { get; }

    /// <summary>How many pixels the picture has.</summary>
    public int PixelCount { get; }

    /// <summary>In how many pixels it differs from the scene's picture by more than rounding.</summary>
    public int WrongCount { get; }

    /// <summary>In how many pixels more it shows what the scene shows a thousandth of a pixel away, where the last bits decide.</summary>
    public int OutlineCount { get; }

    /// <summary>The share of pixels that are right but for a channel that is one level darker: rounding instead of truncating.</summary>
    public double DarkerShare { get; }

    /// <summary>What share of the picture so many pixels are.</summary>
    public double Share(double pixels) => pixels / PixelCount;

    /// <summary>Diagnoses a picture.</summary>
    /// <param name="scene">The scene that it is meant to show, at the picture's size.</param>
    /// <param name="picture">The picture; its size is the scene's, or that turned by a quarter.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    public static Diagnosis Of(Scene scene, Picture picture, int? threads = null)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        if ((picture.Width, picture.Height) != (width, height) && (picture.Width, picture.Height) != (height, width))
            throw new ArgumentException($"a picture of {picture.Width} x {picture.Height} for a scene of {width} x {height}", nameof(picture));
        return new(scene, picture, threads);
    }

    /// <summary>A way to draw the scene wrong, and how near it comes. Each mistake in one of its wordings.</summary>
    private sealed record Trial(IReadOnlyList<Mistake> Wordings, bool OtherSample, Misfit Misfit = default)
    {
        public string Id { get; } = string.Join(' ', Wordings.Select(wording => wording.Id).Order(StringComparer.Ordinal));
    }

    private string? FindMissingModel()
    {
        if (scene.Models.Count > MostMissing) return null;
        for (var i = 0; i < scene.Models.Count; i++)
        {
            var without = new Lab(scene with { Models = [.. scene.Models.Where((_, place) => place != i)] });
            if (Explains(without, FirstLook) && Explains(without, 1)) return ModelName.Of(scene, i);
        }
        return null;

        bool Explains(Lab lab, double share) => evidence.Misfit(lab, share).Unexplained <= Explained * WrongCount;
    }

    private List<Trial> Singles() =>
    [
        .. from mistake in known
           from wording in mistake.Wordings
           from otherSample in mistake == center ? (bool[])[false] : [false, true]
           select new Trial([wording], otherSample),
    ];

    /// <summary>
    /// Whether a mistake is all that is wrong, outlines too: a box that loses its edge to 0 · ∞ is not forgiven. A mistake of the camera may by
    /// chance be the last bits of another program.
    /// </summary>
    private bool IsAll(Mistake mistake, Evidence strict) => (mistake.Concerns & Concerns.Camera) == 0
        && mistake.Wordings.Any(wording => strict.Misfit(new Lab(scene, wording)).Unexplained <= Explained * strict.WrongCount);

    /// <summary>Without those that stand beside rays through the other place of each pixel and explain no more than these alone.</summary>
    private static List<Trial> WithoutIdle(List<Trial> singles)
    {
        if (singles.Find(trial => trial.Id == center.Id) is not { } alone) return singles;
        return [.. singles.Where(trial => !trial.OtherSample || trial.Misfit.Unexplained < 0.9 * alone.Misfit.Unexplained)];
    }

    /// <summary>The nearest single mistakes, each with every other.</summary>
    private List<Trial> Pairs(List<Trial> singles) =>
    [
        .. from single in Distinct(singles).Take(Partners)
           from other in known
           where other.Id != single.Id && !(single.OtherSample && other == center)
           from wording in other.Wordings
           select single with { Wordings = [single.Wordings[0], wording] },
    ];

    /// <summary>Each once, in its nearest wording.</summary>
    private static IEnumerable<Trial> Distinct(IEnumerable<Trial> trials) => trials.DistinctBy(trial => trial.Id);

    /// <summary>Looks at all, looks closer at the best, and sorts these.</summary>
    private List<Trial> Best(List<Trial> trials) => Measured(Measured(trials, FirstLook)[..Math.Min(Closer, trials.Count)], 1);

    private List<Trial> Measured(List<Trial> trials, double share)
    {
        var measured = new Trial[trials.Count];
        Parallel.For(0, trials.Count, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount },
            i => measured[i] = trials[i] with { Misfit = evidence.Misfit(Draw(trials[i]), share) });
        return [.. measured.OrderBy(trial => trial.Misfit)]; // stable: of equals the first in the catalogue
    }

    private Lab Draw(Trial trial) => new(scene, [.. trial.Wordings, .. trial.OtherSample ? (Mistake[])[center] : []]);

    private Suspect AsSuspect(Trial trial)
    {
        Mistake[] twins = [];
        var own = Draw(trial);
        if (trial.Wordings is [var wording] && !own.Scatters)
        {
            twins = [.. known.Where(other => other.Id != wording.Id &&
                other.Wordings.Any(wording => evidence.AreAlike(own, Draw(trial with { Wordings = [wording] }))))];
        }
        return new([.. trial.Wordings.Select(wording => MistakeCatalog.Named(wording.Id)!)], trial.Misfit.Unexplained, trial.OtherSample, twins);
    }
}
