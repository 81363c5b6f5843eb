namespace RayCaster.Teaching;

/// <summary>Some pixels of the evidence, drawn by edited formulas.</summary>
internal sealed class EditSample
{
    private readonly FormulaEvaluator evaluator;
    private readonly FormulaProgram right;
    private readonly byte[] shown;
    private readonly int wrong; // how many of the pixels are wrong; these come first
    private readonly double perWrong, perOther;

    /// <param name="scene">What the program draws of the scene.</param>
    /// <param name="pixels">How many wrong pixels there are at most, and how many right ones.</param>
    public EditSample(Evidence evidence, Scene scene, FormulaProgram right, int pixels)
    {
        this.right = right;
        wrong = Math.Min(pixels, evidence.WrongPixels.Length);
        var other = Math.Min(pixels, evidence.OtherPixels.Length);
        int[] places = [.. evidence.WrongPixels[..wrong], .. evidence.OtherPixels[..other]];
        var width = evidence.Picture.Width;
        evaluator = new(scene, [.. places.Select(place => (place % width, place / width))], right, proposes: true);
        shown = [.. places.SelectMany(place => evidence.Picture.Rgb.AsSpan(3 * place, 3).ToArray())];
        perWrong = 1.0 / Math.Max(1, wrong);
        perOther = (double)(evidence.PixelCount - evidence.WrongCount) / Math.Max(1, evidence.WrongCount) / Math.Max(1, other);
    }

    public byte[] Draw(FormulaEdit edit) => evaluator.Draw(edit.In(right));

    /// <summary>How many pixels what was drawn leaves unexplained, as a share of the wrong ones.</summary>
    public double Unexplained(byte[] drawn)
    {
        var inWrong = 0;
        var inOther = 0;
        for (var i = 0; i < drawn.Length / 3; i++)
        {
            if (IsNear(drawn, shown, i)) continue;
            if (i < wrong) inWrong++;
            else inOther++;
        }
        return perWrong * inWrong + perOther * inOther;
    }

    /// <summary>Whether two edits draw the same, but for one pixel in five hundred.</summary>
    public static bool AreAlike(byte[] one, byte[] other)
    {
        var left = one.Length / 3 / 500;
        for (var i = 0; i < one.Length / 3; i++)
            if (!IsNear(one, other, i) && --left < 0) return false;
        return true;
    }

    private static bool IsNear(byte[] a, byte[] b, int pixel)
    {
        for (var i = 3 * pixel; i < 3 * pixel + 3; i++)
            if (Math.Abs(a[i] - b[i]) > PictureJudge.Tolerance) return false;
        return true;
    }
}
