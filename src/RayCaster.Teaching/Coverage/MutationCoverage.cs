using System.Collections.Concurrent;

namespace RayCaster.Teaching.Coverage;

/// <summary>
/// How good a scene is as a test: which mistakes of the catalogue its picture cannot show, and which it cannot distinguish.
/// Several scenes are judged as a set: one may show what another hides.
/// </summary>
public sealed class MutationCoverage
{
    /// <summary>On scenes with more models, no mistakes are tried.</summary>
    public const int MaxModels = 10_000;

    /// <summary>A smaller picture of the same shape is judged in place of a larger one.</summary>
    private const int MaxPixels = 1_000_000;

    /// <summary>How many pixels are compared for each mistake, and for each of its other variants; a small part of them shows most.</summary>
    internal const int MoreSamples = 60_000, VariantSamples = 15_000;

    /// <summary>How many mistakes are tried between two looks at the budget.</summary>
    private const int Together = 16;

    private MutationCoverage()
    {
    }

    /// <summary>The mistakes that the scenes were tested for.</summary>
    public required IReadOnlyList<Mistake> Tested { get; init; }

    /// <summary>The scenes, in the sizes in which they were judged.</summary>
    public required IReadOnlyList<Scene> Scenes { get; init; }

    /// <summary>Whether a smaller picture was judged in place of a large one.</summary>
    public required bool IsReduced { get; init; }

    /// <summary>The mistakes that change fewer than <see cref="Rendering.LeastPixels"/> pixels of each picture by more than rounding does.</summary>
    public required IReadOnlyList<Mistake> Hidden { get; init; }

    /// <summary>The mistakes that show, but not in the usual way: a program with that may draw the right picture.</summary>
    public required IReadOnlyList<Mistake> SurvivorsInUsualForm { get; init; }

    /// <summary>The hidden mistakes that change pixels by a level: a comparison of bytes shows them.</summary>
    public required IReadOnlyList<Mistake> WithinRounding { get; init; }

    /// <summary>The mistakes that were not tried: those of triangles if a scene has a mesh of many, and all others if the work is done.</summary>
    public required IReadOnlyList<Mistake> NotTried { get; init; }

    /// <summary>Whether the work was done before all mistakes were tried.</summary>
    public required bool IsCut { get; init; }

    /// <summary>Groups of visible mistakes that draw the same pictures.</summary>
    public required IReadOnlyList<IReadOnlyList<Mistake>> Twins { get; init; }

    /// <summary>Whether every picture is of one colour.</summary>
    public required bool ShowsNothing { get; init; }

    /// <summary>Judges a set of scenes.</summary>
    /// <param name="scenes">At least one; each passes <see cref="CanJudge"/>.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <param name="tested">The mistakes that they should show; all of the catalogue if left out.</param>
    /// <param name="budget">How much may be done, in the order of the mistakes; any amount if left out.</param>
    public static MutationCoverage Measure(
        IReadOnlyList<Scene> scenes, int? threads = null, IReadOnlyList<Mistake>? tested = null, SearchBudget? budget = null)
    {
        tested ??= MistakeCatalog.All;
        Scene[] judged = [.. scenes.Select(Judged)];
        var (known, views) = TryAll(judged, tested, threads, budget);
        var hidden = HiddenOf(known, views);
        Mistake[] seen = [.. known.Except(hidden)];
        return new()
        {
            Tested = tested,
            Scenes = judged,
            IsReduced = !judged.SequenceEqual(scenes),
            Hidden = hidden,
            SurvivorsInUsualForm = [.. seen.Where(mistake => !views.Any(view => view.ShowsFirst(mistake)))],
            WithinRounding = [.. hidden.Where(mistake => views.Any(view => view.ShowsByALevel(mistake)))],
            NotTried = [.. tested.Except(known)],
            Twins = Groups(views, [.. seen], budget),
            ShowsNothing = views.All(view => view.IsOfOneColor),
            IsCut = budget?.UsedUp is not null, // at last: the groups may be cut, too
        };
    }

    /// <returns>The mistakes that were tried, and what they show.</returns>
    private static (Mistake[] Known, View[] Views) TryAll(
        IReadOnlyList<Scene> scenes, IReadOnlyList<Mistake> tested, int? threads, SearchBudget? budget)
    {
        Mistake[] known = [.. tested.Where(mistake => scenes.All(scene => CanTry(scene, mistake)))];
        View[] views = [.. scenes.Select(scene => new View(scene, budget))];
        var tried = SearchBudget.Do(budget, known.Length, Together, threads, i =>
        {
            foreach (var view in views) view.Try(known[i]);
        });
        return (known[..tried], views);
    }

    private static Mistake[] HiddenOf(Mistake[] known, View[] views) => [.. known.Where(mistake => !views.Any(view => view.Shows(mistake)))];

    /// <summary>The mistakes of the catalogue that a scene's picture cannot show.</summary>
    /// <returns>These, and how many mistakes were tried.</returns>
    internal static (IReadOnlyList<Mistake> Hidden, int Tried) HiddenIn(
        Scene scene, int? threads, SearchBudget? budget = null, IReadOnlyList<Mistake>? tested = null)
    {
        var (known, views) = TryAll([Judged(scene)], tested ?? MistakeCatalog.Visible, threads, budget);
        return (HiddenOf(known, views), known.Length);
    }

    /// <summary>Whether a scene has so few models that mistakes can be tried on it.</summary>
    public static bool CanJudge(Scene scene) => scene.Models.Count <= MaxModels;

    /// <summary>Whether a scene can show a mistake: a mesh of many triangles is drawn by the definition.</summary>
    public static bool CanTry(Scene scene, Mistake mistake) => CanTry(scene, mistake.Usual);

    /// <summary>The same for what people write.</summary>
    internal static bool CanTry(Scene scene, Change change) => change.In(FormulaProgram.Slides) is not { MutatesTriangles: true }
        || !scene.Models.Any(model => model is Mesh { TriangleCount: > ShapePart.MaxTriangles });

    private static Scene Judged(Scene scene)
    {
        var camera = scene.Camera;
        var most = Math.Clamp(MaxPixels * 50L / Math.Max(1, scene.Models.Count), 2500, MaxPixels); // so that the time stays the same
        var shrink = Math.Sqrt((double)camera.Width * camera.Height / most);
        if (shrink <= 1) return scene;
        return scene.WithSize(Math.Max(1, (int)(camera.Width / shrink)), Math.Max(1, (int)(camera.Height / shrink)));
    }

    /// <summary>The groups of mistakes that no picture distinguishes.</summary>
    private static List<IReadOnlyList<Mistake>> Groups(View[] views, List<Mistake> seen, SearchBudget? budget)
    {
        var groups = new List<IReadOnlyList<Mistake>>();
        while (seen is [var first, ..] && budget?.IsSpent() != true)
        {
            Mistake[] group =
                [.. seen.Where(other => other == first || (budget?.IsSpent() != true && views.All(view => view.AreAlike(first, other))))];
            seen.RemoveAll(group.Contains);
            if (group.Length > 1) groups.Add(group);
        }
        return groups;
    }

    /// <summary>What a scene shows of mistakes.</summary>
    private sealed class View(Scene scene, SearchBudget? budget)
    {
        private readonly Rendering most = Rendering.OfPicture(scene, MoreSamples, budget), few = Rendering.OfPicture(scene, VariantSamples, budget);
        private readonly ConcurrentDictionary<Mistake, FormulaProgram> usual = [];
        private readonly ConcurrentDictionary<Mistake, bool> shown = [], shownFirst = [];

        public bool IsOfOneColor { get; } = FormulaProgram.Slides.Draw(scene).IsOneColor;

        /// <summary>Whether the picture shows a mistake, in any of its variants.</summary>
        public bool Shows(Mistake mistake) => shown.GetValueOrDefault(mistake);

        /// <summary>The same for its first variant.</summary>
        public bool ShowsFirst(Mistake mistake) => shownFirst.GetValueOrDefault(mistake);

        /// <summary>Whether a hidden mistake changes any byte of the samples.</summary>
        public bool ShowsByALevel(Mistake mistake) => mistake.Touches(scene) && !most.AreEqual(usual[mistake], FormulaProgram.Slides);

        /// <summary>Draws as much of the picture as is needed to see the mistake. It is an edit of the slides' formulas: other last bits than the
        /// definition's are none.</summary>
        public void Try(Mistake mistake)
        {
            usual[mistake] = mistake.Usual.In(FormulaProgram.Slides)!;
            if (!mistake.Touches(scene)) return;
            shownFirst[mistake] = Changes(most, usual[mistake]);
            shown[mistake] = shownFirst[mistake]
                || mistake.Changes.Skip(1).Any(variant => variant.In(FormulaProgram.Slides) is { } other && Changes(few, other));
        }

        /// <summary>Whether the pictures of two mistakes differ in fewer pixels than matter.</summary>
        public bool AreAlike(Mistake a, Mistake b) => most.AreAlike(usual[a], usual[b]);

        private static bool Changes(Rendering rendering, FormulaProgram program) => !rendering.AreAlike(FormulaProgram.Slides, program);
    }
}
