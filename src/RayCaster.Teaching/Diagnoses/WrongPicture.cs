namespace RayCaster.Teaching;

/// <summary>The picture of a program with known mistakes: for exams, and for testing a rubric.</summary>
public static class WrongPicture
{
    /// <summary>Draws a scene with mistakes.</summary>
    /// <param name="mistakes">All its mistakes; each is one of the catalogue, or one of its wordings.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <returns>The picture; two of the mistakes swap its width and height.</returns>
    public static Picture Draw(Scene scene, IReadOnlyList<Mistake> mistakes, int? threads = null)
    {
        var lab = new Lab(scene, [.. mistakes]);
        var picture = new Picture(lab.Width, lab.Height);
        Parallel.For(0, lab.Height, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, y =>
        {
            for (var x = 0; x < lab.Width; x++) picture[x, y] = lab[x, y];
        });
        return picture;
    }
}
