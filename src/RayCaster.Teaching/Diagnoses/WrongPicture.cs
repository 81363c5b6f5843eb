namespace RayCaster.Teaching;

/// <summary>What a program with known mistakes draws: for exams, and for trying a rubric.</summary>
public static class WrongPicture
{
    /// <summary>Draws a scene with mistakes.</summary>
    /// <param name="mistakes">The mistakes, made all at once; each is one of the catalogue or one of its wordings.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <returns>The picture; two of the mistakes swap its sides.</returns>
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
