namespace RayCaster.Teaching;

/// <summary>A program: a section for each step, and the few things that no formula says.</summary>
/// <remarks>It never changes; two programs that differ in a step share the others.</remarks>
internal sealed record FormulaProgram
{
    private FormulaProgram(ImmutableArray<FormulaSection> sections) => Sections = sections;

    private ImmutableArray<FormulaSection> Sections { get; init; }

    public FormulaSection this[SectionKind kind] => Sections[(int)kind];

    /// <summary>The rule of some kinds of shape, where it is another than that of all.</summary>
    public ImmutableDictionary<SectionKind, FormulaSection> Rules { get; private init; } = ImmutableDictionary<SectionKind, FormulaSection>.Empty;

    /// <summary>The kinds of shape, by their names in scene files, that are not drawn.</summary>
    public ImmutableHashSet<string> LeftOut { get; init; } = [];

    /// <summary>By how many bytes all bytes of the picture are farther on in the file.</summary>
    public int MovedBytes { get; init; }

    /// <summary>Whether the camera stands at T and looks at P.</summary>
    public bool SwapsEnds { get; init; }

    /// <summary>Whether last bits decide for each pixel if a triangle shows there.</summary>
    public bool Scatters { get; init; }

    /// <summary>Whether formulas decide only about that triangle of a large mesh which the definition hits. Otherwise an edited formula decides
    /// about each triangle, one by one.</summary>
    public bool ProposesTriangles { get; init; }

    /// <summary>Whether the file is as wide as the scene's picture is high, and the other way round.</summary>
    public bool IsTurned => this[SectionKind.File].Has(Formula.Turned);

    /// <summary>The slides' formulas, as a camera measures depth and samples pixels.</summary>
    /// <param name="otherSample">Whether rays pass through the other sample point of each pixel.</param>
    public static FormulaProgram For(Camera camera, bool otherSample = false)
    {
        var book = FormulaBook.Slides;
        return new FormulaProgram([.. Enum.GetValues<SectionKind>().Select(kind => book.StylesOf(kind)[0])])
            .With(book[SectionKind.Rule, camera.Clip == ClipMode.Depth ? "depth" : "distance"])
            .With(book[SectionKind.Sample, camera.Sample == PixelSample.Corner != otherSample ? "corner" : "center"]);
    }

    /// <summary>With mistakes; null if two of them are in the same part of a formula.</summary>
    public FormulaProgram? With(IEnumerable<Mistake> mistakes) =>
        mistakes.Aggregate((FormulaProgram?)this, (program, mistake) => program is null ? null : mistake.In(program));

    /// <summary>The sides of its file.</summary>
    public (int Width, int Height) SizeOf(Camera camera) => IsTurned ? (camera.Height, camera.Width) : (camera.Width, camera.Height);

    /// <summary>The shapes whose own formulas, or whose own rule, are not the slides'.</summary>
    public Affects ChangedShapes => ShapeKind.Basic.Select(shape => Enum.Parse<SectionKind>(shape.Name, ignoreCase: true))
        .Where(kind => !FormulaBook.Slides.StylesOf(kind).Contains(this[kind]) || Rules.ContainsKey(kind))
        .Aggregate((Affects)0, (all, kind) => all | Mistake.AffectedBy(kind));

    /// <summary>How many triangles of meshes each ray must try, one by one, because their formulas are not the slides'.</summary>
    public long TrianglesTried(Scene scene) => !ProposesTriangles && FormulaEvaluator.AreTrianglesEdited(this)
        ? scene.Models.OfType<Mesh>().Where(mesh => mesh.TriangleCount > FormulaEvaluator.MaxTriangles).Sum(mesh => (long)mesh.TriangleCount) : 0;

    /// <summary>How many of some rays are cast within so many tries.</summary>
    public int RaysWithin(Scene scene, double tries, int rays) =>
        TrianglesTried(scene) is > 0 and var triangles ? (int)Math.Min(rays, tries / triangles) : rays;

    /// <summary>How many pixels of a picture a thread draws at a time, at most, unless a line has more.</summary>
    private const int PixelsAtOnce = 4096;

    /// <summary>The whole file.</summary>
    public Picture Draw(Scene scene, int? threads = null)
    {
        var (width, height) = SizeOf(scene.Camera);
        var rgb = new byte[3 * width * height];
        var lines = Math.Max(1, PixelsAtOnce / width); // that are drawn together
        Parallel.For(0, (height + lines - 1) / lines, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, i =>
        {
            var first = i * lines;
            (int, int)[] pixels = [.. from y in Enumerable.Range(first, Math.Min(lines, height - first))
                                      from x in Enumerable.Range(0, width)
                                      select (x, y)];
            FormulaEvaluator.Draw(scene, this, pixels).CopyTo(rgb, 3 * width * first);
        });
        return new(width, height, rgb);
    }

    public FormulaSection RuleOf(SectionKind? kind) => kind is { } own && Rules.TryGetValue(own, out var rule) ? rule : this[SectionKind.Rule];

    public FormulaProgram With(FormulaSection section) => this with { Sections = Sections.SetItem((int)section.Kind, section) };

    /// <summary>With a section in the place of its own; if that has edits, too, with both.</summary>
    /// <param name="section">A style, or one with edits.</param>
    /// <param name="shapes">The kinds of shape whose rule it is; empty for all.</param>
    /// <returns>Null if both edit the same part of a formula, or have different styles.</returns>
    public FormulaProgram? With(FormulaSection section, ImmutableArray<SectionKind> shapes)
    {
        if (shapes.IsEmpty) return this[section.Kind].Merged(section) is { } merged ? With(merged) : null;
        var rules = Rules;
        foreach (var shape in shapes)
        {
            if (RuleOf(shape).Merged(section) is not { } rule) return null;
            rules = rules.SetItem(shape, rule);
        }
        return this with { Rules = rules };
    }
}
