using System.Collections.Concurrent;

namespace RayCaster.Teaching.Coverage;

/// <summary>What programs draw in some places of a scene's picture. Here alone is decided whether two programs draw the same.</summary>
/// <param name="places">Columns from the left and lines from the top; any beginning of them is spread over all.</param>
/// <param name="matter">In how many of the places the pictures of two programs differ, at least, that do not draw the same.</param>
/// <param name="budget">What drawing spends; null if it is not counted.</param>
/// <param name="basis">What all programs differ from by a little, if most places are drawn again and again; null if they are not.</param>
internal sealed class Rendering(
    Scene scene, (int X, int Y)[] places, int matter, SearchBudget? budget, FormulaProgram? basis = null)
{
    /// <summary>A mistake is visible if it changes so many pixels of a picture.</summary>
    public const int LeastPixels = 20;

    /// <summary>How many places tell most programs apart, and how many are drawn at once where they do not.</summary>
    private const int First = 64, AtOnce = 4096;

    private readonly ConcurrentDictionary<Range, ConcurrentBag<FormulaEvaluator>> evaluators = []; // that no thread uses now
    private readonly ConditionalWeakTable<FormulaProgram, Lazy<byte[]>[]> known = [];

    /// <summary>The whole picture of a scene, in a part of its pixels.</summary>
    /// <param name="most">How many pixels.</param>
    public static Rendering OfPicture(Scene scene, int most, SearchBudget? budget)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var spread = new GoldenRatioSequence(width * height);
        var places = new (int, int)[Math.Min(most, width * height)];
        for (var k = 0; k < places.Length; k++) places[k] = (spread[k] % width, spread[k] / width);
        return new(scene, places, (int)Math.Ceiling((double)LeastPixels * places.Length / (width * height)), budget);
    }

    /// <summary>The bytes of some of the places: red, green, blue, and so on.</summary>
    public byte[] Draw(FormulaProgram program, Range some)
    {
        if (basis is null || program.ByteShift != 0) return FormulaEvaluator.Draw(scene, program, places[some], budget);
        var idle = evaluators.GetOrAdd(some, _ => []);
        if (!idle.TryTake(out var evaluator)) evaluator = new(scene, places[some], basis);
        var rgb = evaluator.Draw(program, budget);
        idle.Add(evaluator);
        return rgb;
    }

    /// <summary>Whether two programs draw the same: they differ by more than rounding in fewer places than matter.</summary>
    public bool AreAlike(FormulaProgram one, FormulaProgram other)
    {
        if (one.SizeOf(scene.Camera) != other.SizeOf(scene.Camera)) return false;
        var left = matter;
        for (var (i, ofOne, ofOther) = (0, Known(one), Known(other)); i < ofOne.Length && left > 0; i++)
            left -= Differing(ofOne[i].Value, ofOther[i].Value);
        return left > 0;
    }

    /// <summary>Whether two programs draw the same bytes.</summary>
    public bool AreEqual(FormulaProgram one, FormulaProgram other) =>
        Known(one).Zip(Known(other)).All(piece => piece.First.Value.SequenceEqual(piece.Second.Value));

    /// <summary>Pieces of what a program draws, each drawn once at most.</summary>
    private Lazy<byte[]>[] Known(FormulaProgram program) => known.GetValue(program, own =>
        [.. Pieces().Select(some => new Lazy<byte[]>(() => Draw(own, some)))]);

    private IEnumerable<Range> Pieces()
    {
        for (int first = 0, end; first < places.Length; first = end)
        {
            end = Math.Min(places.Length, first == 0 ? First : first + AtOnce);
            yield return first..end;
        }
    }

    private static int Differing(byte[] one, byte[] other)
    {
        var differing = 0;
        for (var i = 0; i < one.Length; i += 3)
            if (!PictureJudge.IsNear((one[i], one[i + 1], one[i + 2]), (other[i], other[i + 1], other[i + 2]))) differing++;
        return differing;
    }
}
