namespace RayCaster.Teaching;

/// <summary>A program's picture of one scene, and how well a <see cref="Hypothesis"/> explains it.</summary>
internal sealed class ScenePicture
{
    /// <summary>How many pixels a closer look takes, at most.</summary>
    private const int Pixels = 3000;

    /// <summary>From so many pixels the ones are chosen that a hypothesis leaves unexplained.</summary>
    private const int Choice = 1500;

    /// <summary>As many pixels as are looked at for a second mistake: those that the first leaves unexplained, and those that it explains.</summary>
    private const int MostUnexplained = 24, MostExplained = 12;

    /// <summary>
    /// Unexplained shares of a picture are told apart by their logarithms: whether a hundredth or a tenth of it is left says as much as whether a
    /// thousandth or a hundredth is. Below this share they are all alike.
    /// </summary>
    private const double LeastShare = 0.002;

    /// <summary>How far from white to black a pixel must be off to weigh like one that is unexplained: 50 times. Decides between equals.</summary>
    private const double ErrorWeight = 0.02;

    private readonly Evidence evidence;

    /// <param name="of">The scene.</param>
    /// <param name="picture">The picture, as large as the scene's, or that turned by a quarter.</param>
    public ScenePicture(MarkedScene of, Picture picture)
    {
        (Of, Picture) = (of, picture);
        var most = (int)Math.Clamp(Pixels * 500L / Math.Max(1, of.Scene.Models.Count), 300, Pixels);
        evidence = new(of.Scene, of.Right, picture, most, of.Scene.Models.Count <= Lab.MostModels);
        Visible = Math.Max(SceneFitness.LeastPixels, 2.0 * evidence.WrongCount / most) / evidence.PixelCount;
    }

    /// <summary>The scene.</summary>
    public MarkedScene Of { get; }

    /// <summary>The picture.</summary>
    public Picture Picture { get; }

    /// <summary>Whether it is the scene's, but for rounding and single pixels on outlines.</summary>
    public bool IsRight => evidence.WrongCount == 0 || evidence.IsOnlyOutlines;

    /// <summary>The share of its pixels that are wrong.</summary>
    public double WrongShare => (double)evidence.WrongCount / evidence.PixelCount;

    /// <summary>The least share of the picture that tells something: as many pixels as a mistake must change to be seen, or one of those that are looked at.</summary>
    public double Visible { get; }

    /// <summary>The share of the picture that a hypothesis leaves unexplained.</summary>
    /// <param name="hypothesis">The hypothesis.</param>
    /// <param name="share">What share of the chosen pixels is looked at.</param>
    public double Unexplained(Hypothesis hypothesis, double share = 1)
    {
        var misfit = evidence.Misfit(hypothesis.Draw(Of.Scene), share);
        return (misfit.Unexplained + ErrorWeight * misfit.Error) / evidence.PixelCount;
    }

    /// <summary>Whether a hypothesis explains the picture, but for what other mistakes' last bits may do.</summary>
    public bool IsExplainedBy(Hypothesis hypothesis) =>
        Unexplained(hypothesis) <= Math.Max(Visible, Math.Clamp(0.12 * WrongShare, LeastShare, 3 * LeastShare));

    /// <summary>What a hypothesis costs that leaves so much unexplained: 0 for nothing, 1 for as much as is wrong, or more.</summary>
    public double Loss(double unexplained) =>
        Math.Min(1, Math.Log(1 + unexplained / LeastShare) / Math.Log(1 + Math.Max(WrongShare, LeastShare) / LeastShare));

    /// <summary>A few pixels that tell what else is wrong, should a hypothesis be true: most of them are such as it leaves unexplained.</summary>
    public Residue Leave(Hypothesis hypothesis)
    {
        List<int> unexplained = [], explained = [];
        var lab = hypothesis.Draw(Of.Scene);
        if (HasSizeOf(lab))
            for (var k = 0; k < Math.Min(Choice, evidence.PixelCount) && unexplained.Count < MostUnexplained; k++)
                (IsLike(lab, Of.Places[k]) ? explained : unexplained).Add(Of.Places[k]);
        return new(unexplained, [.. explained.Take(MostExplained)], Unexplained(hypothesis, 0.2));
    }

    /// <summary>About what share of the picture a hypothesis would leave unexplained, told from a few pixels.</summary>
    /// <param name="hypothesis">The hypothesis.</param>
    /// <param name="residue">What another left, which lacks a mistake.</param>
    public double Unexplained(Hypothesis hypothesis, Residue residue)
    {
        var lab = hypothesis.Draw(Of.Scene);
        if (!HasSizeOf(lab)) return 1;
        var stillUnexplained = ShareUnlike(lab, residue.Unexplained);
        var spoilt = ShareUnlike(lab, residue.Explained);
        return stillUnexplained * residue.Share + spoilt * (1 - residue.Share);
    }

    private bool HasSizeOf(Lab lab) => (lab.Width, lab.Height) == (Picture.Width, Picture.Height);

    private double ShareUnlike(Lab lab, IReadOnlyList<int> places)
    {
        var unlike = 0;
        foreach (var place in places)
            if (!IsLike(lab, place)) unlike++;
        return places.Count == 0 ? 0 : (double)unlike / places.Count;
    }

    private bool IsLike(Lab lab, int place)
    {
        var (y, x) = Math.DivRem(place, Picture.Width);
        return PictureDifference.Levels(lab[x, y], Picture[x, y]) <= Evidence.Tolerance;
    }

    /// <summary>What a hypothesis leaves of a picture.</summary>
    /// <param name="Unexplained">Some pixels that look otherwise.</param>
    /// <param name="Explained">Some that do not.</param>
    /// <param name="Share">What share of the picture the first are taken from.</param>
    internal sealed record Residue(IReadOnlyList<int> Unexplained, IReadOnlyList<int> Explained, double Share);
}
