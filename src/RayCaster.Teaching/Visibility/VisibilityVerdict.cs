using static System.FormattableString;

namespace RayCaster.Teaching.Visibility;

/// <summary>A visibility in words: what is unusual, why, and what to change.</summary>
internal static class VisibilityVerdict
{
    /// <summary>If more models do not show, only so many are named.</summary>
    private const int MaxNamed = 10;

    public static IEnumerable<string> Find(SceneVisibility visibility)
    {
        if (visibility.Models.Count == 0) return ["The scene holds no models: every pixel shows the background."];
        string[] sentences = [.. visibility.Hits == 0 ? OfNoHits(visibility) : OfLight(visibility).Concat(OfHiddenModels(visibility))];
        return sentences.Length > 0 ? sentences : ["Nothing odd: every model shows."];
    }

    private static IEnumerable<string> OfNoHits(SceneVisibility visibility)
    {
        var groups = visibility.Models.GroupBy(entry => entry.Reason).OrderBy(group => group.Key)
            .Select(group => (Reason: group.Key, Entries: group.ToList())).ToList();
        var parts = groups.Select(group => group.Entries is [var only]
            ? $"{only.Label} {OutcomeText.Find(group.Reason).One}"
            : $"{Digits.Count(group.Entries.Count, "model")} {OutcomeText.Find(group.Reason).Many}");
        return groups.Select(group => Remedy(visibility, group.Reason, group.Entries)).OfType<string>()
            .Prepend($"0 of {Digits.Count(visibility.Rays, "ray")} hit anything: {string.Join(", ", parts)}.");
    }

    /// <summary>What to change if some models do not show for this reason.</summary>
    private static string? Remedy(SceneVisibility visibility, Outcome reason, List<ModelVisibility> group)
    {
        var camera = visibility.Scene.Camera;
        return reason switch
        {
            Outcome.Behind => OfLookingAway(visibility.Scene),
            Outcome.UnderBias => Invariant($"bias is {camera.Bias:G7}: only t > bias is a hit. Make it smaller; 1e-6 is usual."),
            Outcome.BeforeNear =>
                Invariant($"zNear is {camera.ZNear:G7}, but their crossings lie at z = {group.Max(entry => entry.GreatestBeforeNear):G7} ") +
                "and less. Make zNear smaller, or move the camera back.",
            Outcome.BeyondFar =>
                Invariant($"zFar is {camera.ZFar:G7}, but their crossings lie at z = {group.Min(entry => entry.LeastBeyondFar):G7} ") +
                "and more. Make zFar greater.",
            Outcome.Misses when visibility.Scene.Models.All(model => model is Mesh { TriangleCount: 0 }) =>
                "Nothing of the mesh is left: none of its triangles has an area.",
            Outcome.Misses => PercentHit(visibility.Scene, camera.Position, camera.Target, Math.Max(camera.FovY, 120)) > 0
                ? Invariant($"They lie beside the picture: aim target at them (it is {camera.Target}), ") +
                    Invariant($"or make fovY greater (it is {camera.FovY:G7} degrees).")
                : Invariant($"The camera looks past them: it stands at {camera.Position} and looks towards {camera.Target}. ") +
                    "Is target where the models are?",
            _ => null,
        };
    }

    /// <summary>Tries each proposal before it is made.</summary>
    private static string OfLookingAway(Scene scene)
    {
        var (position, target) = (scene.Camera.Position, scene.Camera.Target);
        if (PercentHit(scene, target, position, scene.Camera.FovY) is > 0 and var swapped)
            return Invariant($"Are position and target swapped? From {target} towards {position} {swapped:0} % ") +
                "of the rays hit something.";
        var other = 2 * position - target;
        return PercentHit(scene, position, other, scene.Camera.FovY) is > 0 and var turned
            ? Invariant($"The camera looks away from them: towards target = {other} {turned:0} % of the rays hit something.")
            : Invariant($"The camera stands at {position} and looks towards {target}: is the sign of a coordinate wrong?");
    }

    /// <summary>How many percent of the rays of a small picture from another camera position hit something.</summary>
    private static double PercentHit(Scene scene, Vector3 position, Vector3 target, double fovY)
    {
        const int side = 32;
        var camera = scene.Camera with { Position = position, Target = target, FovY = fovY, Width = side, Height = side };
        return new Renderer(scene with { Camera = camera }, 1).CastHits().Model.Count(model => model >= 0) * 100.0 / (side * side);
    }

    private static IEnumerable<string> OfLight(SceneVisibility visibility)
    {
        var camera = visibility.Scene.Camera;
        var color = visibility.OnlyColor;
        if (visibility.Unlit > visibility.Hits / 2)
        {
            var of = visibility.Unlit == visibility.Hits ? "All" : $"{Digits.Number(visibility.Unlit)} of";
            yield return Invariant($"{of} {visibility.Hits:N0} hits are black: attenuation = 1 - t / (2 |T - P|) is 0 ") +
                Invariant($"from t = {camera.FadeDistance:G7} on, ") +
                Invariant($"and their t is {visibility.Range.Least:G7} to {visibility.Range.Greatest:G7}.");
            yield return "target sets the light, which ends at twice its distance: move it away along the line of sight.";
        }
        else if (color is (0, 0, 0)) yield return "All that is hit is black: the models' own color is [0, 0, 0], or nearly so.";
        else if (color is (255, 255, 255))
            yield return "All that is hit is white: color times attenuation is 1 or more in each channel, and is clamped.";
        else if (color is not null && visibility.Hits == visibility.Rays && camera.FovY < 3)
            yield return Invariant($"All pixels have one colour: fovY is {camera.FovY:G7} degrees, so all rays go nearly the same way. ") +
                Invariant($"In radians it would be {camera.FovY * 180 / Math.PI:0.##} degrees.");
        else if (color is { } only && visibility.Hits == visibility.Rays)
            yield return $"All pixels have the colour {only}: the camera sees a single surface, and from so near that its light does not change.";
        if (color is { } shown && visibility.Hits < visibility.Rays && shown == visibility.Scene.Background.ToBytes())
            yield return "The background has the same colour: choose another one, and the models' outline shows.";
    }

    private static IEnumerable<string> OfHiddenModels(SceneVisibility visibility)
    {
        var missing = 0;
        foreach (var entry in visibility.Models)
        {
            if (entry[Outcome.Shows] > 0 || missing++ >= MaxNamed) continue;
            yield return entry.Hits > 0
                ? $"{entry.Label} does not show: it is hit by {Digits.Count(entry.Hits, "ray")}, but something nearer hides it there."
                : $"{entry.Label} does not show: it {OutcomeText.Find(entry.Reason).One}.";
        }
        if (missing > MaxNamed) yield return $"Nor do {Digits.Number(missing - MaxNamed)} more.";
    }
}
