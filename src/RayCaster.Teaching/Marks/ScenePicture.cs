namespace RayCaster.Teaching;

/// <summary>A student's picture of one scene. Measures how well a <see cref="WrongProgram"/> explains it.</summary>
internal sealed class ScenePicture
{
    /// <summary>How many pixels are looked at, at most.</summary>
    private const int Pixels = 3000;

    /// <summary>The pixels that are looked at for a second mistake are chosen from so many.</summary>
    private const int Choice = 1500;

    /// <summary>How many pixels are chosen at most: those that the first mistake leaves unexplained, and those that it explains.</summary>
    private const int MostUnexplained = 24, MostExplained = 12;

    /// <summary>
    /// Unexplained shares of a picture are compared by their logarithms: a tenth is to a hundredth as a hundredth is to a thousandth. Shares
    /// below this one are taken as equal.
    /// </summary>
    private const double LeastShare = 0.002;

    /// <summary>A wrong pixel's error, 1 for black against white, is added with this weight. It decides only between equal counts.</summary>
    private const double ErrorWeight = 0.02;

    /// <summary>The share of wrong pixels that must show what they should.</summary>
    private const double Nearly = 0.97;

    /// <summary>By how many levels two neighbours of one model may differ, and how many make a border.</summary>
    private const int Step = 8, NewBorder = 40;

    private readonly Evidence evidence;

    /// <param name="picture">The picture. Its size is the scene's, or the scene's with width and height swapped.</param>
    public ScenePicture(MarkedScene of, Picture picture)
    {
        (Of, Picture) = (of, picture);
        var most = (int)Math.Clamp(Pixels * 500L / Math.Max(1, of.Scene.Models.Count), 300, Pixels);
        evidence = new(of.Scene, of.Right, picture, most, of.Scene.Models.Count <= Lab.MostModels);
        Visible = Math.Max(SceneFitness.LeastPixels, 2.0 * evidence.WrongCount / most) / evidence.PixelCount;
    }

    public MarkedScene Of { get; }

    public Picture Picture { get; }

    /// <summary>Whether it is the scene's picture, but for rounding and single pixels on outlines.</summary>
    public bool IsRight => evidence.WrongCount == 0 || evidence.IsOnlyOutlines;

    /// <summary>The share of its pixels that are wrong.</summary>
    public double WrongShare => (double)evidence.WrongCount / evidence.PixelCount;

    /// <summary>The least share of the picture that counts: the pixels that a visible mistake changes at least, or about one that is looked
    /// at.</summary>
    public double Visible { get; }

    /// <summary>The share of the picture that a program leaves unexplained.</summary>
    /// <param name="share">The share of the chosen pixels that is looked at.</param>
    public double Unexplained(WrongProgram program, double share = 1)
    {
        var misfit = evidence.Misfit(program.Draw(Of.Scene), share);
        return (misfit.Unexplained + ErrorWeight * misfit.Error) / evidence.PixelCount;
    }

    /// <summary>Whether a program explains the picture, but for pixels that last bits may change.</summary>
    public bool IsExplainedBy(WrongProgram program) =>
        Unexplained(program) <= Math.Max(Visible, Math.Clamp(0.12 * WrongShare, LeastShare, 3 * LeastShare));

    /// <summary>The loss of a program that leaves a share unexplained: 0 for nothing, 1 for all that is wrong, or more.</summary>
    public double Loss(double unexplained) =>
        Math.Min(1, Math.Log(1 + unexplained / LeastShare) / Math.Log(1 + Math.Max(WrongShare, LeastShare) / LeastShare));

    /// <summary>
    /// In how many wrong pixels each kind of shape and the background shows, if nearly all of them show what they should in another light; empty
    /// if not. Grey is a shade of black and of white, so new borders must be few. A clamped channel has lost the ratio of the colours.
    /// </summary>
    public IReadOnlyDictionary<string, int> InAnotherLight()
    {
        var none = new Dictionary<string, int>();
        if ((Picture.Width, Picture.Height) != (Of.Right.Width, Of.Right.Height)) return none;
        var (models, count) = (new Renderer(Of.Scene).CastHits().Model, new Dictionary<string, int>());
        var (right, difference) = (Of.Right, new PictureDifference(Picture, Of.Right));
        var (wrong, borders) = (0, 0);
        for (var i = 0; i < models.Length; i++)
        {
            var (y, x) = Math.DivRem(i, Picture.Width);
            var shown = Picture[x, y];
            if (difference.LevelsAt(i) <= Evidence.Tolerance || IsClamped(shown) || IsClamped(right[x, y])) continue;
            wrong++;
            if (x > 0 && PictureDifference.Levels(right[x - 1, y], right[x, y]) < Step
                && PictureDifference.Levels(Picture[x - 1, y], shown) > NewBorder) borders++;
            var (kind, color) = models[i] < 0 ? ("background", Of.Scene.Background)
                : (Of.Scene.Models[models[i]].Kind, Of.Scene.Models[models[i]].Color);
            if (Unfinished.IsShadeOf(shown, color)) count[kind] = count.GetValueOrDefault(kind) + 1;
        }
        return count.Values.Sum() >= Nearly * wrong && 4 * borders <= Math.Sqrt(wrong) ? count : none;

        static bool IsClamped((byte R, byte G, byte B) color) => Math.Max(color.R, Math.Max(color.G, color.B)) == byte.MaxValue;
    }

    /// <summary>A few pixels for finding a second mistake: most of them are pixels that a program with one mistake leaves unexplained.</summary>
    public Residue Leave(WrongProgram program)
    {
        List<int> unexplained = [], explained = [];
        var lab = program.Draw(Of.Scene);
        var places = new GoldenSteps(evidence.PixelCount);
        if (HasSizeOf(lab))
            for (var k = 0; k < Math.Min(Choice, evidence.PixelCount) && unexplained.Count < MostUnexplained; k++)
                (IsLike(lab, places[k]) ? explained : unexplained).Add(places[k]);
        return new([.. unexplained], [.. explained.Take(MostExplained)], Unexplained(program, 0.2));
    }

    /// <summary>The share of the picture that a program leaves unexplained, estimated from a few pixels.</summary>
    /// <param name="residue">What the same program with one mistake less left.</param>
    public double Unexplained(WrongProgram program, Residue residue)
    {
        var lab = program.Draw(Of.Scene);
        if (!HasSizeOf(lab)) return 1;
        return ShareUnlike(lab, residue.Unexplained) * residue.Share + ShareUnlike(lab, residue.Explained) * (1 - residue.Share);
    }

    private bool HasSizeOf(Lab lab) => (lab.Width, lab.Height) == (Picture.Width, Picture.Height);

    private double ShareUnlike(Lab lab, int[] places) => places.Length == 0 ? 0 : (double)places.Count(place => !IsLike(lab, place)) / places.Length;

    private bool IsLike(Lab lab, int place)
    {
        var (y, x) = Math.DivRem(place, Picture.Width);
        return PictureDifference.Levels(lab[x, y], Picture[x, y]) <= Evidence.Tolerance;
    }

    /// <summary>Some pixels of a picture, sorted by a program.</summary>
    /// <param name="Unexplained">Pixels that the program draws in another colour.</param>
    /// <param name="Explained">Pixels that the program draws in their colour.</param>
    /// <param name="Share">The share of the picture that the program leaves unexplained.</param>
    internal sealed record Residue(int[] Unexplained, int[] Explained, double Share);
}
