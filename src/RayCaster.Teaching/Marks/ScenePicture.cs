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

    /// <summary>The share of a picture that counts as all of its wrong pixels where fewer are wrong.</summary>
    private const double LeastShare = 0.002;

    /// <summary>How far from white to black a pixel must be off to weigh like one that is unexplained: 50 times. Decides between equals.</summary>
    private const double ErrorWeight = 0.02;

    private readonly Evidence evidence;
    private readonly double scale; // so many unexplained pixels are a loss of 1

    /// <param name="of">The scene.</param>
    /// <param name="picture">The picture, as large as the scene's, or that turned by a quarter.</param>
    public ScenePicture(MarkedScene of, Picture picture)
    {
        (Of, Picture) = (of, picture);
        var most = (int)Math.Clamp(Pixels * 500L / Math.Max(1, of.Scene.Models.Count), 300, Pixels);
        evidence = new(of.Scene, of.Right, picture, most, of.Scene.Models.Count <= Lab.MostModels);
        scale = Math.Max(evidence.WrongCount, LeastShare * evidence.PixelCount);
    }

    /// <summary>The scene.</summary>
    public MarkedScene Of { get; }

    /// <summary>The picture.</summary>
    public Picture Picture { get; }

    /// <summary>Whether it is the scene's, but for rounding and single pixels on outlines.</summary>
    public bool IsRight => evidence.WrongCount == 0 || evidence.IsOnlyOutlines;

    /// <summary>The share of its pixels that are wrong.</summary>
    public double WrongShare => (double)evidence.WrongCount / evidence.PixelCount;

    /// <summary>What a hypothesis leaves unexplained: 0 for nothing, 1 for as many pixels as are wrong, or more.</summary>
    /// <param name="hypothesis">The hypothesis.</param>
    /// <param name="share">What share of the chosen pixels is looked at.</param>
    public double Loss(Hypothesis hypothesis, double share = 1)
    {
        var misfit = evidence.Misfit(hypothesis.Draw(Of.Scene), share);
        return Math.Min(1, (misfit.Unexplained + ErrorWeight * misfit.Error) / scale);
    }

    /// <summary>A few pixels that tell what else is wrong, should a hypothesis be true: most of them are such as it leaves unexplained.</summary>
    public Residue Leave(Hypothesis hypothesis)
    {
        List<int> unexplained = [], explained = [];
        var lab = hypothesis.Draw(Of.Scene);
        if (HasSizeOf(lab))
            for (var k = 0; k < Math.Min(Choice, evidence.PixelCount) && unexplained.Count < MostUnexplained; k++)
                (IsLike(lab, Of.Places[k]) ? explained : unexplained).Add(Of.Places[k]);
        return new(unexplained, [.. explained.Take(MostExplained)], Loss(hypothesis, 0.2));
    }

    /// <summary>About what a hypothesis would leave unexplained, told from a few pixels.</summary>
    /// <param name="hypothesis">The hypothesis.</param>
    /// <param name="residue">What another left, which lacks a mistake.</param>
    public double Loss(Hypothesis hypothesis, Residue residue)
    {
        var lab = hypothesis.Draw(Of.Scene);
        if (!HasSizeOf(lab)) return 1;
        var stillUnexplained = ShareUnlike(lab, residue.Unexplained);
        var spoilt = ShareUnlike(lab, residue.Explained);
        return Math.Min(1, stillUnexplained * residue.Loss + spoilt * evidence.PixelCount / scale);
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
    /// <param name="Loss">Its loss.</param>
    internal sealed record Residue(IReadOnlyList<int> Unexplained, IReadOnlyList<int> Explained, double Loss);
}
