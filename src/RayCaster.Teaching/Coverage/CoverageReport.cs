namespace RayCaster.Teaching.Coverage;

/// <summary>A <see cref="MutationCoverage"/> in words for teachers, with what to change.</summary>
public static class CoverageReport
{
    /// <summary>Why a scene hides mistakes.</summary>
    /// <param name="Why">The reason, and what to change.</param>
    private sealed record Reason(Func<Scene, bool> Holds, string Why, params string[] Ids);

    /// <summary>A mistake's reason is the first one that holds and names it.</summary>
    private static readonly Reason[] reasons =
    [
        new(scene => scene.Models.Count == 0, "the world is empty: add models"),
        new(scene => scene.Camera.Width == scene.Camera.Height, "the picture is square: make it 3:2, say 300 x 200",
            "aspect-inv", "aspect-none", "aspect-int", "fov-horiz", "whswap", "transpose", "size-mixed", "uv-swap"),
        new(scene => scene.Camera.Width < 2 * scene.Camera.Height && scene.Camera.Width > scene.Camera.Height,
            "width / height in whole numbers is 1",
            "aspect-int"),
        new(scene => scene.Camera.W.Z == 0 || scene.Camera.Up * scene.Camera.W == 0,
            "the camera is level, at right angles to up: raise its position or lower its target", "u-unnorm", "cross-z", "len-nosqrt", "v-up"),
        new(scene => scene.Models.OfType<Model<Sphere>>().All(model => model.Primitive.Radius == 1),
            "every sphere has the radius 1: take another", "r-nosq", "d-nosq"),
        new(scene => scene.Models.OfType<Model<Circle>>().All(model => model.Primitive.Radius == 1),
            "every circle has the radius 1: take another", "circ-nosq"),
        new(_ => true, "no camera is inside a sphere: put one there", "near-root-only"),
        new(_ => true, "no camera is inside a sphere and looks away from its middle: turn it about", "tca-positive"),
        new(_ => true, "no camera is inside a box: put one there", "slab-inside"),
        new(_ => true,
            "no coordinate of the camera lies on a box's face while a ray runs along it: give camera, target and a box one coordinate in common",
            "slab-inv-nan"),
        new(_ => true, "nothing near is cut by zNear, or nothing shows behind what is cut: move zNear into the scene",
            "znear-t", "no-znear", "bias-big", "clip-after", "zboth-t"),
        new(_ => true, "no sphere or box is cut open by zNear: let the near clip plane pass through one", "clip-root"),
        new(_ => true, "nothing is cut by zFar: move zFar into the scene", "zfar-t", "no-zfar"),
        new(_ => true, "nothing lies behind the camera, or what does is hidden: put a model or a plane there", "no-t0"),
        new(_ => true, "every triangle shows the same side: turn one about by swapping two corners", "tri-cull"),
        new(_ => true, "every plane shows the side of its normal: turn a normal about", "plane-cull"),
        new(_ => true, "no colour leaves 0 to 1: let one be brighter than 1 near the camera", "noclamp"),
        new(_ => true,
            "the models are in an order, or so far from each other, that it does not matter which hit wins: put the nearest first and last",
            "last-hit", "far-hit"),
        new(_ => true, "left and right look alike: put a model to one side", "u-cross", "u-only", "cols", "cross-x", "cross-y", "cross-z"),
    ];

    /// <summary>Lines of text.</summary>
    public static string Text(MutationCoverage fitness)
    {
        var text = new StringBuilder();
        var one = fitness.Scenes.Count == 1;
        text.AppendLine($"{(one ? "As a test the scene shows" : $"As a test these {fitness.Scenes.Count} scenes together show")} " +
            (fitness.IsCut && fitness.NotTried.Count > 0
                ? $"{Shown(fitness)} of the {fitness.Tested.Count - fitness.NotTried.Count} known mistakes that were tried; " +
                    $"{fitness.NotTried.Count} were not (--all tries them)."
                : $"{Shown(fitness)} of the {fitness.Tested.Count} known mistakes."));
        if (fitness.IsReduced) text.AppendLine("A large picture was judged by a smaller one of the same shape.");
        var hidden = fitness.Hidden.Except(fitness.WithinRounding).ToArray();
        if (hidden.Length > 0)
        {
            text.AppendLine($"{(hidden.Length == 1 ? "One makes" : $"{hidden.Length} make")} no difference that can be seen:");
            foreach (var group in hidden.GroupBy(mistake => ReasonFor(mistake, fitness)))
            {
                text.AppendLine($"  {group.Key}");
                foreach (var mistake in group) text.AppendLine($"    {mistake.Id,-14} {mistake.Cause}");
            }
        }
        if (fitness.SurvivingAsUsual.Count > 0)
        {
            text.AppendLine("These show in one form and are hidden in another:");
            foreach (var mistake in fitness.SurvivingAsUsual) text.AppendLine($"    {mistake.Id,-14} hidden as: {mistake.Cause}");
        }
        if (fitness.WithinRounding.Count > 0)
            text.AppendLine($"Only a comparison of the bytes shows {string.Join(", ", fitness.WithinRounding.Select(mistake => mistake.Id))}: " +
                "they change a channel by a level.");
        if (fitness.Twins.Count > 0)
        {
            text.AppendLine("These are seen, but cannot be told apart:");
            foreach (var group in fitness.Twins) text.AppendLine($"  {string.Join(" = ", group.Select(mistake => mistake.Id))}");
            if (fitness.Scenes.All(scene => scene.Background == Color.Black))
                text.AppendLine("  The background is black: another colour tells a black model from none.");
        }
        else if (fitness.IsCut) text.AppendLine("Not all were compared with each other (--all does): some may not be told apart.");
        if (fitness.NotTried.Count > 0)
            text.AppendLine(
                $"Not tried, since {(fitness.IsCut ? "the usual amount of work is done (--all tries them)" : "there are too many triangles")}: " +
                $"{string.Join(", ", fitness.NotTried.Select(mistake => mistake.Id))}.");
        text.AppendLine(fitness.FragilePixels == 0
            ? "No pixel depends on the last bits of the camera's numbers."
            : string.Create(CultureInfo.InvariantCulture,
                $"{fitness.FragilePixels:N0} of {fitness.PixelCount:N0} pixels are fragile: " +
                $"they show another model when a number of the camera moves by its last bit. Another right program may differ there."));
        return text.ToString();
    }

    private static int Shown(MutationCoverage fitness) => fitness.Tested.Count - fitness.Hidden.Count - fitness.NotTried.Count;

    private static string ReasonFor(Mistake mistake, MutationCoverage fitness)
    {
        if (fitness.ShowsNothing && !fitness.Scenes.All(scene => scene.Models.Count == 0))
            return "the picture is of one colour: nothing is to be seen in it";
        if (fitness.Scenes.Any(scene => scene.Models.Count > 0) && !fitness.Scenes.Any(mistake.Touches)) return $"there is no {Needs(mistake)}";
        foreach (var reason in reasons)
            if ((reason.Ids.Length == 0 || reason.Ids.Contains(mistake.Id)) && fitness.Scenes.All(reason.Holds))
                return reason.Why;
        return "nothing in the picture depends on it";
    }

    private static string Needs(Mistake mistake) =>
        string.Join(" or ", ShapeKind.Basic.Where(kind => mistake.Touches(kind.Name)).Select(kind => kind.One));
}
