using System.Collections.Concurrent;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Points for pictures that <see cref="EditedLab"/> draws.</summary>
public class MarkerTests
{
    private static readonly Rubric whole = RubricReader.Read(ProjectFolder.PathOf("docs/rubric.json"), out _)!;

    private static readonly ConcurrentDictionary<string, MarkedScene> smaller = [];

    /// <summary>Some scenes of the course's rubric, which show all that is planted here.</summary>
    internal static readonly Rubric four = With(whole.Items, "1-planes 3-inside 4-flat 4-all"),
        two = With(whole.Items, "3-inside 4-all");

    public static IEnumerable<ITheoryDataRow> Rows => TestTable.Read("Marks/Marks.txt");

    [Theory]
    [MemberData(nameof(Rows))]
    public void AProgramIsMarked(string scenes, string program, string lost, string undecided, string says)
    {
        var marks = Mark(With(whole.Items, scenes), scene => ProgramInWords.Draw(scene, program));
        Assert.Equal((lost, undecided), (Lost(marks), Names(marks.Items.Where(item => item.Undecided > 0))));
        Assert.Contains(says, string.Join('\n', marks.LookYourself));
        Assert.Equal(undecided != "", marks.LookYourself.Count > 0);
    }

    /// <summary>The course's rubric with some of its scenes, in pictures a quarter as large if they are not "full".</summary>
    private static Rubric With(IReadOnlyList<RubricItem> items, string names)
    {
        string[] words = names.Split(' ');
        var scenes = names == "full" ? whole.Scenes : whole.Scenes.Where(scene => words.Contains(scene.Name));
        return With(items, words[0] == "full" ? scenes : scenes.Select(Small));
    }

    private static Rubric With(IReadOnlyList<RubricItem> items, IEnumerable<MarkedScene> scenes) => new([.. scenes])
    {
        Title = whole.Title,
        Hint = whole.Hint,
        Items = items,
        Pictures = whole.Pictures,
    };

    private static MarkedScene Small(MarkedScene scene) => smaller.GetOrAdd(scene.Name, _ => scene with
    {
        Diagnoser = new(scene.Scene.WithSize(scene.Scene.Camera.Width / 2, scene.Scene.Camera.Height / 2)),
    });

    internal static StudentMarks Mark(Rubric rubric, Func<Scene, Picture?> draw) => new Marker(rubric).Mark("somebody",
        [.. rubric.Scenes.Select(
            scene => draw(scene.Scene) is { } picture ? new SubmittedPicture(scene, picture, null) : new(scene, null, "no picture"))]);

    private static string Lost(StudentMarks marks) => Names(marks.Items.Where(item => item.Points < item.Of));

    /// <summary>The numbers with which items' names begin.</summary>
    private static string Names(IEnumerable<ItemMarks> items) => string.Join(' ', items.Select(item => item.Name.Split(' ')[0]));

    [Theory]
    [InlineData("Both", "ok", 12, "2")]
    [InlineData("Both", "ok", 9, "0 +2")]     // the two contradict each other
    [InlineData("Both", "r-nosq", 12, "0 +2")]
    [InlineData("Both", "r-nosq", 9, "0")]
    [InlineData("Tests", "r-nosq", 12, "2")]
    [InlineData("Tests", "ok", 9, "0")]
    [InlineData("Tests", "ok", 0, "0 +2")]    // they did not run
    [InlineData("Pictures", "ok", 9, "2")]
    public void PicturesAndTestsOfAStepDecideTogether(string evidence, string mistake, int passed, string expected)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = Enum.Parse<ItemEvidence>(evidence), Step = 8 };
        var both = With([item], "4-all");
        var scene = both.Scenes[0];
        var picture = EditedLab.Render(scene.Scene, PlantedMistake.Named(mistake));
        Dictionary<int, StepResult>? tests = passed == 0 ? null : new() { [8] = new(8, passed, 12) };
        var marks = new Marker(both).Mark("somebody", [new(scene, picture, null)], tests);
        Assert.Equal(expected, $"{marks.Points}{(marks.Undecided > 0 ? $" +{marks.Undecided}" : "")}");
        Assert.Equal(evidence == "Both" && expected == "0 +2" ? [$"8 Sphere: {passed} of 12 tests of step 8 pass, "
            + $"but its pictures {(mistake == "ok" ? "cost no points" : "cost points")}"]
            : passed == 0 ? ["8 Sphere: neither pictures nor tests decide this"] : Array.Empty<string>(), marks.LookYourself);
    }

    [Theory]
    [InlineData("Tests", 8, 1, 0.0, 2.0)] // rays and shapes use the vectors
    [InlineData("Both", 8, 1, 2.0, 0.0)]
    [InlineData("Tests", 8, 3, 0.0, 0.0)] // a sphere is no plane
    [InlineData("Tests", 5, 3, 0.0, 2.0)] // the light's tests look at a plane
    public void AStepThatFailsWithOneThatItUsesLosesNothing(string evidence, int step, int used, double points, double undecided)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = Enum.Parse<ItemEvidence>(evidence), Step = step };
        var both = With([item], "4-all");
        var tests = new Dictionary<int, StepResult> { [used] = new(used, 3, 4), [step] = new(step, 3, 4) };
        var marks = new Marker(both).Mark("somebody", [new(both.Scenes[0], both.Scenes[0].Right, null)], tests);
        Assert.Equal((points, undecided), (marks.Points, marks.Undecided));
    }

    [Fact]
    public void AMistakeThatLosesAShapeIsNamedBesideTheMissingShape()
    {
        var marks = Mark(two, scene => EditedLab.Render(scene, PlantedMistake.Named("slab-noswap")));
        Assert.Equal(["aabb"], marks.MissingParts);
        Assert.Contains("slab-noswap", marks.HidingMistakes);
        Assert.StartsWith("If they are written: ", MarkWords.Question("aabb", marks.HidingMistakes));
    }

    [Fact]
    public void APartThatOnlyAMissingPictureShowsIsUndecided()
    {
        var parts = With([new("Plane", 1, 1, [], ["plane"]), new("Sphere", 2, 2, [], ["sphere"])], four.Scenes);
        var marks = Mark(parts, scene => scene == four.Scenes[0].Scene ? ScalarRenderer.Render(scene) : null);
        Assert.Equal((1.0, 2.0), (marks.Points, marks.Undecided)); // no sphere is in the only picture
    }

    [Fact] // a camera that looks backwards sees no sphere, so spheres may be unwritten
    public void AShapeThatAMistakeKeepsOutOfAllPicturesIsUndecided()
    {
        var walls = Small(whole.Scenes[0]);
        var ball = Model.Of(new Sphere(walls.Scene.Camera.Target, 1));
        var room = walls with { Diagnoser = new(walls.Scene with { Models = [.. walls.Scene.Models, ball] }) };
        var marks = Mark(With(whole.Items, [room]), scene => EditedLab.Render(scene, PlantedMistake.Named("w-sign")));
        Assert.Equal("4", Lost(marks).Replace(" 8", ""));
        Assert.Equal(2, marks.Items[7].Undecided);
    }

    [Fact]
    public void TheUntouchedHandOutGetsNoPointsAndIsNotUndecided()
    {
        var marks = Mark(four, scene =>
        {
            var (picture, camera) = (new Picture(scene.Camera.Width, scene.Camera.Height), scene.Camera);
            for (var r = 0; r < camera.Height; r++) // the stub of Scene.CastRay
                for (var c = 0; c < camera.Width; c++)
                    picture[c, camera.Height - 1 - r] = new Color((double)c / camera.Width, (double)r / camera.Height, 0.5).ToBytes();
            return picture;
        });
        Assert.Equal((0.0, 0.0), (marks.Points, marks.Undecided));
        Assert.Single(marks.LookYourself);
    }

    [Fact]
    public void PicturesOfOneColourTellNothing()
    {
        var marks = Mark(four, scene => new Picture(scene.Camera.Width, scene.Camera.Height));
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.Equal("all pictures are of one colour: many mistakes cause that", Assert.Single(marks.LookYourself));
    }

    [Fact(Explicit = true)]
    public void WhatNothingExplainsIsUndecidedAndFlaggedAndNotLost()
    {
        var random = new Random(1);
        var marks = Mark(two, scene =>
        {
            var noise = new Picture(scene.Camera.Width, scene.Camera.Height);
            random.NextBytes(noise.Rgb);
            return noise;
        });
        Assert.Equal((0.0, 20.0), (marks.Points, marks.Undecided));
        Assert.Empty(marks.Mistakes);
        Assert.Equal("3-inside, 4-all: no known mistake explains this", Assert.Single(marks.LookYourself));
    }

    [Theory(Explicit = true)]
    [InlineData(false, "a slip in")]
    [InlineData(true, "all outlines are right, only the light is not")]
    public void WhereAllOutlinesAreRightOnlyTheLightIsUndecided(bool isCurved, string expected)
    {
        var marks = Mark(two, scene =>
        {
            var picture = ScalarRenderer.Render(scene);
            for (var i = 0; i < picture.Rgb.Length; i += 3)
            {
                var pixel = picture.Rgb.AsSpan(i, 3);
                var light = isCurved ? 0.6 - 0.0004 * (pixel[0] + pixel[1] + pixel[2]) : 0.5;
                foreach (ref var level in pixel) level = (byte)(light * level);
            }
            return picture;
        });
        Assert.Equal((18.0, "5"), (marks.Points, Lost(marks)));
        Assert.Contains(expected, Assert.Single(marks.LookYourself));
    }

    [Fact(Explicit = true)]
    public void WhereTheLightOfOneKindOfShapeIsWrongItsItemIsUndecided()
    {
        var spheres = With(whole.Items, "3-spheres 4-all");
        var marks = new Marker(spheres).Mark(
            "somebody", [.. spheres.Scenes.Select(scene => new SubmittedPicture(scene, Darkened(scene), null))]);
        Assert.Contains("8", Lost(marks).Split(' '));

        static Picture Darkened(MarkedScene scene)
        {
            var (picture, models) = (ScalarRenderer.Render(scene.Scene), new Renderer(scene.Scene).CastHits().Model);
            for (var i = 0; i < picture.Rgb.Length; i++)
                if (models[i / 3] is >= 0 and var model && scene.Scene.Models[model].Kind == "sphere") picture.Rgb[i] = (byte)(picture.Rgb[i] * 0.7);
            return picture;
        }
    }

    [Theory(Explicit = true)]
    [InlineData(12, 0.0, 2.0)]
    [InlineData(9, 0.0, 0.0)]
    public void TestsThatAllPassDoNotDecideWhatNoMistakeExplains(int passed, double points, double undecided)
    {
        var item = whole.Items.Single(item => item.Name == "8 Sphere") with { Evidence = ItemEvidence.Both, Step = 8 };
        var both = With([item], "4-all");
        var right = both.Scenes[0].Right;
        var foreign = new Picture(right.Width, right.Height);
        for (var i = 0; i < right.Count; i++) foreign[i % right.Width, i / right.Width] = ((byte)(37 * i), (byte)(i / 91), (byte)(i * i / 13));
        var marks = new Marker(both).Mark("somebody", [new(both.Scenes[0], foreign, null)],
            new Dictionary<int, StepResult> { [8] = new(8, passed, 12) });
        Assert.Equal((points, undecided), (marks.Points, marks.Undecided));
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
}
