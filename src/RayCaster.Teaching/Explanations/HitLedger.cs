using System.Text;

namespace RayCaster.Teaching;

/// <summary>
/// Counts, model by model, what becomes of the rays of a picture: which pixels it shows in, and why its other crossings are refused. Taken from
/// the models' own formulas.
/// </summary>
public sealed class HitLedger
{
    /// <summary>The most rays of a sample.</summary>
    public const int MostSampled = 65_536;

    /// <summary>Formulas that take about a second; with more a sample of the rays is judged.</summary>
    private const long MostFormulas = 8_000_000;

    /// <summary>So many models and triangles are judged in a few seconds, mostly in one.</summary>
    private const long MostPartsOfQuick = 500_000;

    private readonly LedgerEntry[] entries;

    private HitLedger(Scene scene, LedgerEntry[] entries) => (Scene, this.entries) = (scene, entries);

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The models in the order of the scene.</summary>
    public IReadOnlyList<LedgerEntry> Models => entries;

    /// <summary>How many rays have been judged.</summary>
    public long Rays { get; private set; }

    /// <summary>How many of them hit something.</summary>
    public long Hits { get; private set; }

    /// <summary>How many hits are black since they lie beyond 2 |T − P|.</summary>
    public long Unlit { get; private set; }

    /// <summary>The least and the greatest t of hits; +∞ and −∞ if there are none.</summary>
    public (double Least, double Greatest) Range { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>Whether all hits have one colour, and which; null if not.</summary>
    internal (byte R, byte G, byte B)? OnlyColor { get; private set; }

    /// <summary>Casts the rays: all of them, or in a large picture, or with many models, a grid of at most <see cref="MostSampled"/>.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="cancellation">Ends the work with an <see cref="OperationCanceledException"/>.</param>
    public static HitLedger Take(Scene scene, CancellationToken cancellation = default)
    {
        var (camera, models) = (scene.Camera, scene.Models);
        var entries = new LedgerEntry[models.Count];
        var witnesses = new ModelWitness[models.Count];
        var cost = 1L;
        for (var i = 0; i < models.Count; i++)
        {
            (entries[i], witnesses[i]) = (new(ModelName.Typed(scene, i)), new(models[i], camera.Position));
            cost += witnesses[i].Cost;
        }
        var ledger = new HitLedger(scene, entries);
        var step = StepOf(camera, cost);
        // From the middle of the first step on, which in a picture of one line is that line.
        var (firstColumn, firstRow) = (Math.Min(step, camera.Width) / 2, Math.Min(step, camera.Height) / 2);
        for (var row = firstRow; row < camera.Height; row += step)
        {
            for (var column = firstColumn; column < camera.Width; column += step)
            {
                cancellation.ThrowIfCancellationRequested();
                ledger.Judge(witnesses, column, row);
            }
        }
        return ledger;
    }

    /// <summary>Whether a scene is judged so soon that nobody minds who has not asked for it: its parts count, in however few models they
    /// are.</summary>
    public static bool IsQuick(Scene scene)
    {
        var parts = 0L;
        foreach (var model in scene.Models) parts += model is Mesh mesh ? mesh.TriangleCount : 1;
        return parts <= MostPartsOfQuick;
    }

    /// <summary>The table, and in words what is odd.</summary>
    public string Report()
    {
        var text = new StringBuilder();
        LedgerTable.Write(this, text);
        foreach (var sentence in LedgerVerdict.Of(this)) text.Append(sentence).Append('\n');
        return text.ToString();
    }

    private void Judge(ModelWitness[] witnesses, int column, int row)
    {
        var ray = Scene.Camera.CastRay(column, row);
        var (nearest, shown) = (double.PositiveInfinity, -1);
        for (var i = 0; i < witnesses.Length; i++)
        {
            var outcome = witnesses[i].Judge(ray, out var t);
            if (outcome == Outcome.Shows && !(t < nearest)) outcome = Outcome.Hidden;
            entries[i].Count(outcome, t * ray.ZPerT);
            if (outcome != Outcome.Shows) continue;
            if (shown >= 0) entries[shown].Hide();
            (nearest, shown) = (t, i);
        }
        Rays++;
        if (shown < 0) return;

        var color = Scene.Shade(nearest, Scene.Models[shown]).ToBytes();
        OnlyColor = Hits == 0 || OnlyColor == color ? color : null;
        Hits++;
        if (nearest >= Scene.Camera.Reach) Unlit++;
        Range = (Math.Min(Range.Least, nearest), Math.Max(Range.Greatest, nearest));
    }

    /// <summary>Every how many columns and rows a ray is judged.</summary>
    private static int StepOf(Camera camera, long cost)
    {
        if ((double)camera.Width * camera.Height * cost <= MostFormulas) return 1;
        var rays = Math.Clamp(MostFormulas / cost, 256, MostSampled);
        var step = 1;
        while ((camera.Width + step - 1L) / step * ((camera.Height + step - 1L) / step) > rays) step++;
        return step;
    }
}
