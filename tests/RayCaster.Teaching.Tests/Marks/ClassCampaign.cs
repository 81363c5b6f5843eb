using RayCaster.Teaching.Tests.Formulas;
using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Marks.MarkerTests;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>A class: 8 right submissions in as many styles, 60 with mistakes that are not in the catalogue, unfinished and 20 broken ones.</summary>
public class ClassCampaign
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
        ["camera"] = "4", ["pixel"] = "4", ["file"] = "4", ["plane"] = "3", ["sphere"] = "8", ["aabb"] = "7", ["circle"] = "9",
        ["triangle"] = "10", ["rule"] = "6", ["light"] = "5", ["bytes"] = "5",
    };

    public static TheoryData<string> Styles =>
        ["truncates", "float", "truncates float", "own", "sphere abc", "sphere foot", "triangle areas", "light doubled"];

    [Theory(Explicit = true)]
    [MemberData(nameof(Styles))]
    public void ARightProgramGetsAllPoints(string style)
    {
        var marks = Mark(two, scene => style == "own" ? new PlantedSlips(scene, -1).Draw()
            : style.Split(' ') is [var kind, var way] && Enum.TryParse<SectionKind>(kind, ignoreCase: true, out var step) ? InStyle(scene, step, way)
            : EditedLab.Render(scene, new(style.Contains("truncates"), Float: style.Contains("float")), Planted.None, Planted.None));
        Assert.Equal((20.0, 0.0), (marks.Points, marks.Undecided));
    }

    [Fact(Explicit = true)]
    [Trait("runs", "weekly")]
    public void AtMostOneOfAHundredItemsIsBlamedInnocently()
    {
        var planted = slips.Select(slip => (slip.New, slip.Items, (Func<Scene, Picture>)(scene =>
                EditedLab.Render(scene, new Planted(slip.New, "", new Edit(slip.File, slip.Old, slip.New))))))
            .Concat(PlantedSlips.All.Select((slip, i) =>
                (slip.What, itemOf[slip.Section], (Func<Scene, Picture>)(scene => new PlantedSlips(scene, i).Draw()))).Where((_, i) => i % 3 > 0))
            .ToArray();
        var (blamed, unnoticed) = (new List<string>(), new List<string>());
        var undecided = 0;
        foreach (var ((what, guilty, _), marks) in planted.Zip(planted.AsParallel().AsOrdered().Select(one => Mark(two, one.Item3)).ToArray()))
        {
            undecided += marks.Items.Count(item => item.Undecided > 0);
            if (marks.Points == 20) unnoticed.Add(what);
            foreach (var item in marks.Items.Where(item => item.Points + item.Undecided < item.Of))
                if (!guilty.Split(' ').Contains(item.Name.Split(' ')[0])) blamed.Add($"{what}: {item.Name}, by {string.Join(' ', item.Because)}");
        }
        Assert.True(100 * blamed.Count <= 10 * planted.Length, string.Join('\n', blamed));
        Assert.Empty(unnoticed);
        Assert.True(undecided < 3 * planted.Length, $"{undecided} items are undecided");
    }

    [Theory(Explicit = true)]
    [InlineData("")]
    [InlineData("sphere")]
    [InlineData("circle triangle")]
    [InlineData("aabb sphere")]
    public void WhatIsUnfinishedCostsItsItems(string undone)
    {
        var marks = Mark(two, scene => new PlantedSlips(Without(scene, undone), -1).Draw());
        var items = two.Items.Where(item => item.Undone.Intersect(undone.Split(' ')).Any()).Select(item => item.Name.Split(' ')[0]);
        Assert.Equal(items, Lost(marks));
    }

    public static TheoryData<int> Ways => [.. Enumerable.Range(0, 20)];

    [Theory(Explicit = true)]
    [MemberData(nameof(Ways))]
    public void ABrokenPictureIsUndecidedAndFlagged(int way)
    {
        using var folder = new TemporaryFolder();
        SubmittedPicture Read(MarkedScene scene)
        {
            var path = folder[scene.Name + ".png"];
            PictureFile.Write(path, scene.Right);
            var bytes = File.ReadAllBytes(path);
            if (way < 10) bytes = bytes[..(bytes.Length * way / 10)];
            else new Random(way).NextBytes(bytes.AsSpan(bytes.Length * (way - 10) / 10, 8));
            File.WriteAllBytes(path, bytes);
            return SubmittedPicture.Read(scene, path);
        }
        var marks = new Marker(two).Mark("somebody", [.. two.Scenes.Select(Read)]);
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.NotEmpty(marks.LookYourself);
    }

    private static Picture InStyle(Scene scene, SectionKind kind, string style) =>
        FormulaProgram.For(scene.Camera).With(FormulaBook.Slides[kind, style]).Draw(scene);
}
