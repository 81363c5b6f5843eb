namespace RayCaster.Teaching;

/// <summary>A program: a section for each step.</summary>
internal sealed class FormulaProgram
{
    private readonly ImmutableArray<FormulaSection> sections;

    private FormulaProgram(ImmutableArray<FormulaSection> sections) => this.sections = sections;

    public FormulaSection this[SectionKind kind] => sections[(int)kind];

    /// <summary>The slides' formulas, as a camera measures depth and samples pixels.</summary>
    /// <param name="otherSample">Whether rays pass through the other sample point of each pixel.</param>
    public static FormulaProgram For(Camera camera, bool otherSample = false)
    {
        var book = FormulaBook.Slides;
        return new FormulaProgram([.. Enum.GetValues<SectionKind>().Select(kind => book.StylesOf(kind)[0])])
            .With(book[SectionKind.Rule, camera.Clip == ClipMode.Depth ? "depth" : "distance"])
            .With(book[SectionKind.File, camera.Sample == PixelSample.Corner != otherSample ? "corner" : "center"]);
    }

    public FormulaProgram With(FormulaSection section) => new(sections.SetItem((int)section.Kind, section));
}
