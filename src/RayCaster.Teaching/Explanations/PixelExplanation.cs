namespace RayCaster.Teaching.Explanations;

/// <summary>
/// How one pixel gets its colour: the ray, each model's formula with this pixel's numbers, the result of each crossing, and the colour.
/// The code that draws computes it, so it agrees with the picture.
/// </summary>
public sealed class PixelExplanation
{
    /// <summary>If there are more models, only those that matter for the pixel are explained one by one.</summary>
    private const int ManyModels = 12;

    /// <summary>Of many models, so many are explained besides those that show here or in a neighbouring pixel.</summary>
    private const int NearestCount = 6;

    /// <summary>Explains a pixel.</summary>
    /// <param name="column">c, from the left, from 0.</param>
    /// <param name="line">The picture's line, from the top, from 0: row r = Height − 1 − line of the formulas.</param>
    /// <exception cref="ArgumentOutOfRangeException">The picture has no such pixel.</exception>
    public PixelExplanation(Scene scene, int column, int line)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(column);
        ArgumentOutOfRangeException.ThrowIfNegative(line);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(column, scene.Camera.Width);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(line, scene.Camera.Height);
        (Scene, Column, Line) = (scene, column, line);
        Ray = scene.Camera.RayThrough(column, Row);
        Hit = ScalarRenderer.Cast(scene, column, Row);
        Neighbours = [.. FindNeighbours()];
        Results = [.. scene.Models.Select((model, i) => RayResult.Create(model, i, Ray, Hit))];
        var explained = Results.Count <= ManyModels ? Results : NearMisses();
        Models = [.. explained.Select(result => new ModelExplanation(this, result))];
        foreach (var result in Results.Except(explained)) Others[result.Outcome]++;
        (ColorSteps, Color) = PixelSteps.OfColor(scene, Hit);
    }

    internal Scene Scene { get; }

    internal int Column { get; }

    internal int Line { get; }

    /// <summary>r, from the bottom, from 0.</summary>
    internal int Row => Scene.Camera.Height - 1 - Line;

    /// <summary>W, U, V, h and w: the same for all pixels.</summary>
    internal IReadOnlyList<NamedValue> CameraSteps => PixelSteps.OfCamera(Scene.Camera);

    /// <summary>uc, ur, the direction before and after normalising.</summary>
    internal IReadOnlyList<NamedValue> RaySteps => PixelSteps.OfRay(Scene.Camera, Column, Row);

    internal Ray Ray { get; }

    /// <summary>The ray's nearest hit.</summary>
    internal Hit Hit { get; }

    /// <summary>The index in the scene of the model that the pixel shows; null for the background.</summary>
    internal int? Winner => IndexOf(Hit);

    /// <summary>What the pixels beside it show.</summary>
    internal IReadOnlyList<Neighbour> Neighbours { get; }

    /// <summary>Of all models, in the scene's order.</summary>
    internal IReadOnlyList<RayResult> Results { get; }

    /// <summary>The models in the scene's order; of more than <see cref="ManyModels"/> those that matter for the pixel.</summary>
    internal IReadOnlyList<ModelExplanation> Models { get; }

    /// <summary>The models that are not among <see cref="Models"/>.</summary>
    internal Tally Others { get; } = new();

    /// <summary>The steps of the attenuation, which the background has not, of each channel and its level, whose whole part is the byte.</summary>
    internal IReadOnlyList<NamedValue> ColorSteps { get; }

    /// <summary>The colour before it is clamped.</summary>
    internal Color Color { get; }

    /// <summary>The pixel's bytes in the picture.</summary>
    public (byte R, byte G, byte B) Bytes => Color.ToBytes();

    /// <summary>What is special about this pixel, in words.</summary>
    internal IReadOnlyList<string> Notes => PixelNotes.Find(this);

    /// <summary>A model's name, or its path in the scene file.</summary>
    internal string NameOf(int? index) => ModelName.Plain(Scene, index ?? -1);

    private static int? IndexOf(Hit hit) => hit.Model < 0 ? null : hit.Model;

    private IEnumerable<Neighbour> FindNeighbours()
    {
        foreach (var (where, column, line) in ((string, int, int)[])
            [("left", Column - 1, Line), ("right", Column + 1, Line), ("above", Column, Line - 1), ("below", Column, Line + 1)])
        {
            if (column < 0 || line < 0 || column >= Scene.Camera.Width || line >= Scene.Camera.Height) continue;
            var hit = ScalarRenderer.Cast(Scene, column, Scene.Camera.Height - 1 - line);
            yield return new(where, column, line, IndexOf(hit), hit.T);
        }
    }

    /// <summary>The model that shows, those that neighbouring pixels show, and the others whose crossings are nearest to the camera. In the scene's
    /// order.</summary>
    private IReadOnlyList<RayResult> NearMisses()
    {
        HashSet<int?> chosen =
        [
            Winner,
            .. Neighbours.Select(neighbour => neighbour.Model),
            .. Results.Where(result => result.Outcome is not (Outcome.Shows or Outcome.Misses))
                .OrderBy(result => Math.Abs(result.T)).Take(NearestCount)
                .Select(result => (int?)result.Index),
        ];
        return [.. Results.Where(result => chosen.Contains(result.Index))];
    }
}

/// <summary>What a neighbouring pixel shows.</summary>
/// <param name="Where">left, right, above or below.</param>
/// <param name="Model">The model's index in the scene; null for the background.</param>
/// <param name="T">The t of its hit; +∞ for none.</param>
internal sealed record Neighbour(string Where, int Column, int Line, int? Model, double T);
