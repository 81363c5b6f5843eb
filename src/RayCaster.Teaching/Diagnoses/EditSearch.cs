namespace RayCaster.Teaching;

/// <summary>Edits that draw the same evidence, the likeliest first.</summary>
/// <param name="Unexplained">The share of the wrong pixels that they leave unexplained.</param>
internal sealed record EditGroup(double Unexplained, ImmutableArray<FormulaEdit> Edits)
{
    public double Cost => Edits[0].Cost;
}

/// <summary>Finds the small edits of the slides' formulas that draw a wrong picture.</summary>
/// <remarks>All edits are tried on a few pixels, the nearest on more, and the nearest of these on all of the evidence.</remarks>
/// <param name="way">What the program does not do yet.</param>
/// <param name="otherSample">Whether rays pass through the other sample point of each pixel.</param>
/// <exception cref="TimeoutException">The budget is spent.</exception>
internal sealed class EditSearch(Evidence evidence, Unfinished way, bool otherSample, SearchBudget? budget)
{
    /// <summary>How many wrong pixels, and how many right ones, each round compares.</summary>
    private const int FewPixels = 24, MorePixels = 200, AllPixels = 1500;

    /// <summary>How many edits each round takes on at least, and at most if they are nearly as good as the last of these.</summary>
    private const int FewEdits = 300, MaxFewEdits = 700, LastEdits = 40, MaxLastEdits = 250;

    private const double NearlyAsGood = 0.05, AlmostAsGood = 0.01;

    /// <summary>How much a cost counts beside an unexplained share while edits are sorted, and when the best group is chosen.</summary>
    private const double SmallCost = 0.001, GroupCost = 1 / 150.0;

    /// <summary>How many of the nearest edits of the camera are tried in other styles of the shapes if no edit explains the picture.</summary>
    private const int EditsInStyles = 24;

    private const int MaxGroups = 4, MaxOthers = 8;

    /// <summary>The share that an edit may leave and still explain the picture.</summary>
    private readonly double mayLeave = Math.Min(MayLeave, Math.Max(MayLeavePixels, MayLeaveOfPicture * evidence.PixelCount) / evidence.WrongCount);

    private readonly Scene scene = way.PartOf(evidence.Scene);
    private readonly FormulaProgram right = way.PartOf(FormulaProgram.For(evidence.Scene.Camera, otherSample));

    private static readonly SectionKind[] shapes =
        [SectionKind.Plane, SectionKind.Circle, SectionKind.Sphere, SectionKind.Aabb, SectionKind.Triangle];

    /// <summary>In a scene of more models that have formulas, nothing is searched for.</summary>
    private const int MaxModels = 200;

    /// <summary>What the likeliest edits may leave, in pixels or as a share of the picture, and as a share of what is wrong: less is the right
    /// edit, drawn with other last bits; more is chance.</summary>
    private const double MayLeavePixels = 8, MayLeaveOfPicture = 0.001, MayLeave = 0.05;

    /// <summary>The edits that explain the picture, the best first; and the nearest others, one of which may be half of what is wrong.</summary>
    public (IReadOnlyList<EditGroup> Explaining, IReadOnlyList<EditGroup> Others) Find()
    {
        if (scene.Models.Count > MaxModels || !evidence.HasRightSize) return ([], []);
        var all = Run().ToLookup(group => group.Unexplained <= mayLeave);
        return ([.. all[true].Take(MaxGroups)], [.. all[false].Where(group => group.Unexplained < 1).Take(MaxOthers)]);
    }

    /// <summary>The groups of edits that come nearest, the best first.</summary>
    private IEnumerable<EditGroup> Run()
    {
        var few = new EditSample(evidence, scene, right, FewPixels);
        var more = new EditSample(evidence, scene, right, MorePixels);
        var nearest = Nearest(few, AllEdits());
        var closer = Measured(more, nearest);
        if (closer is [var best, ..] && best.Unexplained > mayLeave)
        {
            var ofRays = closer.Select(edit => edit.Edit).Where(ShowsInShapes).Take(EditsInStyles);
            closer = Sorted([.. closer, .. ofRays.Select(edit => InStyles(more, edit)).OfType<(double, FormulaEdit)>()]);
        }
        var all = new EditSample(evidence, scene, right, AllPixels);
        var groups = new List<(byte[] Drawn, List<(double Unexplained, FormulaEdit Edit)> Edits)>();
        foreach (var (_, edit) in closer.TakeWhile((edit, i) =>
            i < LastEdits || (i < MaxLastEdits && edit.Unexplained < closer[0].Unexplained + AlmostAsGood)))
        {
            budget?.ThrowIfSpent();
            var drawn = all.Draw(edit);
            var same = groups.Find(group => EditSample.AreAlike(group.Drawn, drawn)).Edits;
            if (same is null) groups.Add((drawn, same = []));
            same.Add((all.Unexplained(drawn), edit));
        }
        return groups.Select(group => GroupOf(group.Edits)).OrderBy(group => group.Unexplained + GroupCost * group.Cost);
    }

    /// <summary>Edits that draw nearly the same: those of them that explain the picture, or all if none does.</summary>
    private EditGroup GroupOf(List<(double Unexplained, FormulaEdit Edit)> edits)
    {
        var least = edits.Min(edit => edit.Unexplained);
        return new(least, [.. from edit in edits where edit.Unexplained <= mayLeave || least > mayLeave orderby edit.Edit.Cost select edit.Edit]);
    }

    /// <summary>The edits of each step that the scene shows, in each style.</summary>
    private IEnumerable<FormulaEdit> AllEdits()
    {
        var kinds = scene.Models.Select(model => FormulaEvaluator.KindOf(model)).ToHashSet();
        foreach (var kind in Enum.GetValues<SectionKind>().Where(kind => !shapes.Contains(kind) || kinds.Contains(kind)))
        {
            foreach (var section in FormulaBook.Slides.StylesOf(kind).Where(IsPossible))
            {
                var edits = EditFactory.EditsOf(section);
                foreach (var edit in kind == SectionKind.Plane ? [.. edits, .. shared.Value] : edits)
                {
                    yield return edit;
                    if (kind == SectionKind.Vectors)
                        yield return edit with { Beside = [FormulaBook.Slides[SectionKind.Light, "doubled"]], Cost = edit.Cost + 0.1 };
                    if (kind == SectionKind.Camera && edit.Formula?.Name.Text == "W" && scene.Camera.Clip == ClipMode.Depth)
                        yield return edit with { Beside = [FormulaBook.Slides[SectionKind.Rule, "aim"]], Cost = edit.Cost + 0.1 };
                }
            }
        }
    }

    /// <summary>Slips in the plane's t that circles and triangles share, because it is one method for all of them.</summary>
    private static readonly Lazy<FormulaEdit[]> shared = new(() =>
    [
        .. from edit in EditFactory.EditsOf(FormulaBook.Slides.StylesOf(SectionKind.Plane)[0])
           where edit.Place is not null
           let circle = Alike(edit, FormulaBook.Slides.StylesOf(SectionKind.Circle)[0], "C")
           let triangle = Alike(edit, FormulaBook.Slides[SectionKind.Triangle, "shares"], "A")
           where circle is not null
           from both in triangle is null ? [edit with { Beside = [circle] }] : (FormulaEdit[])
               [edit with { Beside = [circle] }, edit with { Beside = [circle, triangle] }, edit with { Section = circle, Beside = [triangle] }]
           select both with { Cost = edit.Cost + 0.1 },
    ]);

    /// <summary>A section with the same edit; null if there is none.</summary>
    /// <param name="point">What Q is called there.</param>
    private static FormulaSection? Alike(FormulaEdit edit, FormulaSection section, string point) => EditFactory.EditsOf(section).FirstOrDefault(
        other => other.Operator == edit.Operator && other.Formula?.Name == edit.Formula!.Name && other.Meant == edit.Meant.Replace("Q", point)
            && other.Written == edit.Written.Replace("Q", point))?.Section;

    /// <summary>Whether a style computes what the scene needs.</summary>
    private bool IsPossible(FormulaSection section) => section.Kind switch
    {
        SectionKind.File => section == right[SectionKind.File],
        SectionKind.Rule => section.Style == "distance" == (scene.Camera.Clip == ClipMode.Distance),
        _ => true,
    };

    /// <summary>Whether it shows otherwise in shapes of another style.</summary>
    private static bool ShowsInShapes(FormulaEdit edit) => edit.Section.Kind is SectionKind.Vectors or SectionKind.Camera or SectionKind.Pixel;

    private List<FormulaEdit> Nearest(EditSample few, IEnumerable<FormulaEdit> edits)
    {
        var sorted = Measured(few, edits);
        var last = sorted[Math.Min(FewEdits, sorted.Count) - 1].Unexplained + NearlyAsGood;
        return [.. sorted.TakeWhile((edit, i) => i < FewEdits || (i < MaxFewEdits && edit.Unexplained <= last)).Select(edit => edit.Edit)];
    }

    private List<(double Unexplained, FormulaEdit Edit)> Measured(EditSample sample, IEnumerable<FormulaEdit> edits)
    {
        var measured = new List<(double, FormulaEdit)>();
        foreach (var edit in edits)
        {
            budget?.ThrowIfSpent();
            measured.Add((sample.Unexplained(sample.Draw(edit)), edit));
        }
        return Sorted(measured);
    }

    private static List<(double Unexplained, FormulaEdit Edit)> Sorted(List<(double Unexplained, FormulaEdit Edit)> edits) =>
        [.. edits.OrderBy(edit => edit.Unexplained + SmallCost * edit.Edit.Cost)];

    /// <summary>An edit with each shape and the rule in the style in which it explains most; null if that is no better.</summary>
    private (double, FormulaEdit)? InStyles(EditSample sample, FormulaEdit edit)
    {
        var best = sample.Unexplained(sample.Draw(edit));
        var beside = edit.Beside;
        foreach (var kind in shapes.Concat([SectionKind.Rule, SectionKind.Light]))
        {
            foreach (var section in FormulaBook.Slides.StylesOf(kind).Where(section => section != right[kind] && IsPossible(section)))
            {
                budget?.ThrowIfSpent();
                var other = beside.Add(section);
                var left = sample.Unexplained(sample.Draw(edit with { Beside = other }));
                if (left < best - AlmostAsGood) (best, beside) = (left, other);
            }
        }
        return beside != edit.Beside ? (best, edit with { Beside = beside, Cost = edit.Cost + 0.3 }) : null;
    }
}
