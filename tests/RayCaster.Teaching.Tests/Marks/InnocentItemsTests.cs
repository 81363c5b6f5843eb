using RayCaster.Teaching.Tests.Formulas;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Slips that are not in the catalogue may cost the items of their formulas, and hardly any other.</summary>
public class InnocentItemsTests
{
    /// <summary>Edits of the lab that the catalogue does not have, and the items that they may cost.</summary>
    private static readonly (string Items, string File, string Old, string New)[] slips =
    [
        ("", "Scene", "? Background :", "? new Color(0, 0, 0) :"),
        ("5", "Camera", "Math.Max(0, attenuation) *", "Math.Pow(Math.Max(0, attenuation), 3) *"),
        ("5", "Camera", "Math.Max(0, attenuation) *", "Math.Sin(Math.Max(0, attenuation)) *"),
        ("1", "Vector3", "a.Z * b.Z;", "a.Z * a.Z;"),
        ("1", "Vector3", "a.X * b.X + a.Y * b.Y + a.Z * b.Z", "a.X * b.X + a.Z * b.Z"),
        ("1", "Vector3", "a.X * b.X + a.Y * b.Y + a.Z * b.Z", "a.X * b.X + a.Y * b.Y - a.Z * b.Z"),
        ("1", "Vector3", "a.X * b.X + a", "a.X * b.Y + a"),
        ("1", "Vector3", "new(a.X - b.X,", "new(a.X + b.X,"),
        ("1", "Vector3", "a.Z - b.Z);", "a.Z - b.Y);"),
        ("1", "Vector3", "a.Y - b.Y, a.Z -", "a.Y + b.Y, a.Z -"),
        ("1", "Vector3", "a.Z + b.Z);", "a.Z - b.Z);"),
        ("1", "Vector3", "new(a.X + b.X,", "new(a.X - b.X,"),
        ("1", "Vector3", "b * a.Y,", "a.Y,"),
        ("1", "Vector3", "b * a.Z);", "b * a.Y);"),
        ("1", "Vector3", "new(b * a.X,", "new(a.X,"),
        ("4", "Camera", "(Up % W)", "(new Vector3(0, 0, 1) % W)"),
        ("4", "Camera", "(Up % W)", "(new Vector3(0, 1, 0) % W)"),
        ("1 4", "Vector3", "new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X)",
            "new(a.Z * b.Y - a.Y * b.Z, a.X * b.Z - a.Z * b.X, a.Y * b.X - a.X * b.Y)"),
        ("7", "Aabb", "Slab(B0.Y, B1.Y, P.Y, d.Y)", "Slab(B0.X, B1.X, P.X, d.X)"),
        ("2", "Ray", "Origin + t * Direction", "t * Direction"),
    ];

    private static readonly Dictionary<string, string> itemOf = new()
    {
        ["vectors"] = "1", ["camera"] = "4", ["pixel"] = "4", ["file"] = "4", ["plane"] = "3", ["sphere"] = "8", ["aabb"] = "7", ["circle"] = "9",
        ["triangle"] = "10", ["rule"] = "6", ["light"] = "5", ["bytes"] = "5",
    };

    [Fact(Explicit = true)]
    [Trait("runs", "weekly")]
    public void AtMostOneOfAHundredItemsIsBlamedInnocently()
    {
        var planted = slips.Select(slip => (What: slip.New, slip.Items, Mistake: PlantedMistake.Of(new SourceEdit(slip.File, slip.Old, slip.New))))
            .Concat(UnseenSlips.All.Select(slip => (slip.What, Items: itemOf[slip.Section], Mistake: PlantedMistake.Of(slip.Edits))))
            .Where(slip => MarkerTests.two.Scenes.Any(scene => ShowsIn(scene, slip.Mistake))).ToArray();
        var (blamed, unnoticed) = (new List<string>(), new List<string>());
        var undecided = 0;
        foreach (var (what, guilty, mistake) in planted)
        {
            var marks = MarkerTests.Mark(MarkerTests.two, scene => EditedLab.Render(scene, mistake));
            undecided += marks.Items.Count(item => item.Undecided > 0);
            if (marks.Points == 20) unnoticed.Add(what);
            foreach (var item in marks.Items.Where(item => item.Points + item.Undecided < item.Of))
                if (!guilty.Split(' ').Contains(item.Name.Split(' ')[0])) blamed.Add($"{what}: {item.Name}, by {string.Join(' ', item.Because)}");
        }
        Assert.True(planted.Length >= 60, $"only {planted.Length} slips show");
        Assert.True(100 * blamed.Count <= 10 * planted.Length, string.Join('\n', blamed));
        Assert.Empty(unnoticed);
        Assert.True(undecided < 3 * planted.Length, $"{undecided} items are undecided");
    }

    private static bool ShowsIn(MarkedScene scene, PlantedMistake mistake) =>
        ChangedPixels.Count(EditedLab.Render(scene.Scene, mistake), scene.Right, levels: 2) >= SceneFitness.LeastPixels;
}
