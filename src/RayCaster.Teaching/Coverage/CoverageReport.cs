namespace RayCaster.Teaching.Coverage;

/// <summary>A <see cref="MutationCoverage"/> in words for teachers, with what to change.</summary>
public static class CoverageReport
{
    /// <summary>Why a scene hides mistakes.</summary>
    /// <param name="Name">What Mistakes.txt calls it.</param>
    /// <param name="Why">The reason, and what to change.</param>
    /// <param name="Holds">Whether it holds in a scene; in each if null.</param>
    private sealed record Reason(string Name, string Why, Func<Scene, bool>? Holds = null);

    /// <summary>A mistake's reason is the first one that holds and hides it.</summary>
    private static readonly Reason[] reasons =
    [
        new("square picture", "the picture is square: make it 3:2, say 300 x 200", scene => scene.Camera.Width == scene.Camera.Height),
        new("nearly square picture",
            "width / height in whole numbers is 1",
            scene => scene.Camera.Width < 2 * scene.Camera.Height && scene.Camera.Width > scene.Camera.Height),
        new("level camera",
            "the camera is level, at right angles to up: raise its position or lower its target",
            scene => scene.Camera.W.Z == 0 || scene.Camera.Up * scene.Camera.W == 0),
        new("spheres of radius 1",
            "every sphere has the radius 1: take another", scene => scene.Models.OfType<Model<Sphere>>().All(model => model.Primitive.Radius == 1)),
        new("circles of radius 1",
            "every circle has the radius 1: take another", scene => scene.Models.OfType<Model<Circle>>().All(model => model.Primitive.Radius == 1)),
        new("no camera in a sphere", "no camera is inside a sphere: put one there"),
        new("no camera in a sphere that looks outwards", "no camera is inside a sphere and looks away from its middle: turn it about"),
        new("no camera in a box", "no camera is inside a box: put one there"),
        new("no ray along a face",
            "no coordinate of the camera lies on a box's face while a ray runs along it: give camera, target and a box one coordinate in common"),
        new("nothing cut by zNear", "nothing near is cut by zNear, or nothing shows behind what is cut: move zNear into the scene"),
        new("nothing cut open by zNear", "no sphere or box is cut open by zNear: let the near clip plane pass through one"),
        new("nothing cut by zFar", "nothing is cut by zFar: move zFar into the scene"),
        new("nothing behind the camera", "nothing lies behind the camera, or what does is hidden: put a model or a plane there"),
        new("one side of triangles", "every triangle shows the same side: turn one about by swapping two corners"),
        new("one side of planes", "every plane shows the side of its normal: turn a normal about"),
        new("no colour out of range", "no colour leaves 0 to 1: let one be brighter than 1 near the camera"),
        new("order without effect",
            "the models are in an order, or so far from each other, that it does not matter which hit wins: put the nearest first and last"),
        new("symmetric picture", "left and right look alike: put a model to one side"),
    ];

    /// <summary>What may hide mistakes, as Mistakes.txt calls it.</summary>
    internal static IEnumerable<string> Reasons => reasons.Select(reason => reason.Name);

    /// <summary>Lines of text.</summary>
    public static string Text(MutationCoverage coverage)
    {
        var text = new StringBuilder();
        var one = coverage.Scenes.Count == 1;
        text.AppendLine($"{(one ? "As a test the scene shows" : $"As a test these {coverage.Scenes.Count} scenes together show")} " +
            (coverage.IsCut && coverage.NotTried.Count > 0
                ? $"{Shown(coverage)} of the {coverage.Tested.Count - coverage.NotTried.Count} known mistakes that were tried; " +
                    $"{coverage.NotTried.Count} were not (--all tries them)."
                : $"{Shown(coverage)} of the {coverage.Tested.Count} known mistakes."));
        if (coverage.IsReduced) text.AppendLine("A large picture was judged by a smaller one of the same shape.");
        var hidden = coverage.Hidden.Except(coverage.WithinRounding).ToArray();
        if (hidden.Length > 0)
        {
            text.AppendLine($"{(hidden.Length == 1 ? "One makes" : $"{hidden.Length} make")} no difference that can be seen:");
            foreach (var group in hidden.GroupBy(mistake => ReasonFor(mistake, coverage)))
            {
                text.AppendLine($"  {group.Key}");
                foreach (var mistake in group) text.AppendLine($"    {mistake.Id,-14} {mistake.Cause}");
            }
        }
        if (coverage.SurvivorsInUsualForm.Count > 0)
        {
            text.AppendLine("These show in one form and are hidden in another:");
            foreach (var mistake in coverage.SurvivorsInUsualForm) text.AppendLine($"    {mistake.Id,-14} hidden as: {mistake.Cause}");
        }
        if (coverage.WithinRounding.Count > 0)
            text.AppendLine($"Only a comparison of the bytes shows {string.Join(", ", coverage.WithinRounding.Select(mistake => mistake.Id))}: " +
                "they change a channel by a level.");
        if (coverage.Twins.Count > 0)
        {
            text.AppendLine("These are seen, but cannot be told apart:");
            foreach (var group in coverage.Twins) text.AppendLine($"  {string.Join(" = ", group.Select(mistake => mistake.Id))}");
            if (coverage.Scenes.All(scene => scene.Background == Color.Black))
                text.AppendLine("  The background is black: another colour tells a black model from none.");
        }
        else if (coverage.IsCut) text.AppendLine("Not all were compared with each other (--all does): some may not be told apart.");
        if (coverage.NotTried.Count > 0)
            text.AppendLine(
                $"Not tried, since {(coverage.IsCut ? "the usual amount of work is done (--all tries them)"
                    : $"a mesh of more than {ShapePart.MaxTriangles} triangles is always drawn rightly")}: " +
                $"{string.Join(", ", coverage.NotTried.Select(mistake => mistake.Id))}.");
        return text.ToString();
    }

    private static int Shown(MutationCoverage coverage) => coverage.Tested.Count - coverage.Hidden.Count - coverage.NotTried.Count;

    private static string ReasonFor(Mistake mistake, MutationCoverage coverage)
    {
        if (coverage.Scenes.All(scene => scene.Models.Count == 0)) return "the world is empty: add models";
        if (coverage.ShowsNothing) return "the picture is of one colour: nothing is to be seen in it";
        if (!coverage.Scenes.Any(mistake.Touches)) return $"there is no {Needs(mistake)}";
        var hiding = reasons.FirstOrDefault(reason => mistake.HiddenBy.Contains(reason.Name)
            && coverage.Scenes.All(scene => reason.Holds?.Invoke(scene) != false));
        return hiding?.Why ?? "nothing in the picture depends on it";
    }

    private static string Needs(Mistake mistake) =>
        string.Join(" or ", ShapeKind.Basic.Where(kind => mistake.Touches(kind.Name)).Select(kind => kind.One));
}
