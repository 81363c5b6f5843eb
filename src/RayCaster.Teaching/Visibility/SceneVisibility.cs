namespace RayCaster.Teaching.Visibility;

/// <summary>
/// Counts the results of a picture's rays for each model: how many pixels show the model, and why other crossings do not count. The models'
/// own formulas decide.
/// </summary>
public sealed class SceneVisibility
{
    /// <summary>The most rays that a sample has.</summary>
    public const int MaxSampled = 65_536;

    /// <summary>So many evaluations of a formula take about a second. If more are needed, only a sample of the rays is judged.</summary>
    private const long MaxFormulas = 8_000_000;

    /// <summary>Finding the triangles of a mesh that a ray may cross takes about as long as so many formulas.</summary>
    private const long FormulasOfTree = 32;

    /// <summary>So many shapes are judged within a few seconds, mostly within one.</summary>
    private const long MaxShapesOfQuick = 500_000;

    private SceneVisibility(Scene scene) =>
        (Scene, Models) = (scene, [.. scene.Models.Select((_, i) => new ModelVisibility(ModelName.Typed(scene, i)))]);

    /// <summary>The models in the order of the scene.</summary>
    public IReadOnlyList<ModelVisibility> Models { get; }

    /// <summary>How many rays were judged.</summary>
    public long Rays { get; private set; }

    internal Scene Scene { get; }

    /// <summary>How many of the rays hit something.</summary>
    internal long Hits { get; private set; }

    /// <summary>How many hits are black because t ≥ 2 |T − P|.</summary>
    internal long Unlit { get; private set; }

    /// <summary>The least and the greatest t of hits; +∞ and −∞ if there are none.</summary>
    internal (double Least, double Greatest) Range { get; private set; } = (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The colour of all hits; null if they have several.</summary>
    internal (byte R, byte G, byte B)? OnlyColor { get; private set; }

    /// <summary>Judges all rays. In a large picture or a scene of many models, judges a grid of at most <see cref="MaxSampled"/> rays.</summary>
    public static SceneVisibility Take(Scene scene, CancellationToken cancellation = default)
    {
        var camera = scene.Camera;
        var visibility = new SceneVisibility(scene);
        var step = StepOf(camera, 1 + scene.Models.Sum(model => model is Mesh ? FormulasOfTree : 1L));
        // Starts in the middle of the first step; in a picture of one line that is the line.
        var (firstColumn, firstRow) = (Math.Min(step, camera.Width) / 2, Math.Min(step, camera.Height) / 2);
        for (var row = firstRow; row < camera.Height; row += step)
        {
            for (var column = firstColumn; column < camera.Width; column += step)
            {
                cancellation.ThrowIfCancellationRequested();
                visibility.Count(column, row);
            }
        }
        return visibility;
    }

    /// <summary>Whether judging a scene is quick enough to be done without a request. All triangles of meshes are counted.</summary>
    public static bool IsQuick(Scene scene) => scene.ShapeCount <= MaxShapesOfQuick;

    /// <summary>The table, and in words what is unusual.</summary>
    public string Report() => VisibilityTable.Format(this) + string.Concat(VisibilityVerdict.Find(this).Select(sentence => sentence + "\n"));

    private void Count(int column, int row)
    {
        var ray = Scene.Camera.RayThrough(column, row);
        var nearest = double.PositiveInfinity;
        var shown = -1;
        for (var i = 0; i < Models.Count; i++)
        {
            var outcome = RayResult.Classify(Scene.Models[i], ray, out var t);
            if (outcome == Outcome.Shows && t < nearest)
            {
                if (shown >= 0) Models[shown][Outcome.Hidden]++;
                (nearest, shown) = (t, i);
            }
            else Models[i].Count(outcome == Outcome.Shows ? Outcome.Hidden : outcome, t * ray.DepthPerT);
        }
        Rays++;
        if (shown < 0) return;

        Models[shown][Outcome.Shows]++;
        var color = Scene.Shade(new(nearest, shown)).ToBytes();
        OnlyColor = Hits == 0 || OnlyColor == color ? color : null;
        Hits++;
        if (nearest >= Scene.Camera.FadeDistance) Unlit++;
        Range = (Math.Min(Range.Least, nearest), Math.Max(Range.Greatest, nearest));
    }

    /// <summary>The distance between judged rays, in columns and rows.</summary>
    private static int StepOf(Camera camera, long cost)
    {
        if ((double)camera.Width * camera.Height * cost <= MaxFormulas) return 1;
        var rays = Math.Clamp(MaxFormulas / cost, 256, MaxSampled);
        var step = 1;
        while ((camera.Width + step - 1L) / step * ((camera.Height + step - 1L) / step) > rays) step++;
        return step;
    }
}
