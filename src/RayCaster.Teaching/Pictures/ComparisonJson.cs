namespace RayCaster.Teaching;

/// <summary>A comparison for other programs: one JSON object, every number by its name.</summary>
public static class ComparisonJson
{
    /// <summary>The text. Lines count from the top, rows from the bottom.</summary>
    /// <param name="warning">Why what it says of the scene may be wrong; left out if null.</param>
    public static string Of(PictureComparison comparison, string mine, string reference, string? warning = null)
    {
        var (d, r) = (comparison.Difference, comparison.Recognition);
        return JsonText.Of(new
        {
            Warning = warning,
            Mine = Named(mine, comparison.Mine),
            Reference = Named(reference, comparison.Reference),
            Verdict = ComparisonText.Of(comparison.Likeness),
            Same = comparison.Likeness.IsSame(),
            d?.Pixels,
            d?.Wrong,
            d?.OffByOne,
            d?.OneDarker,
            WrongMiddle = d?.WrongMiddle is var (x, y) ? Middle(d, x, y) : null,
            WrongArea = d?.WrongArea is var (left, top, right, bottom) ? new
            {
                FirstColumn = left,
                LastColumn = right,
                FirstLine = top,
                LastLine = bottom,
                FirstRow = d.Mine.Height - 1 - bottom,
                LastRow = d.Mine.Height - 1 - top,
            } : null,
            Measures = d is null ? null : Measures(d),
            Recognised = r is null ? null : Recognised(r),
            Scene = comparison.ByModels is { } models ? Models(comparison.Scene!, models) : null,
        });
    }

    private static object Named(string file, Picture picture) => new { File = file, picture.Width, picture.Height };

    private static object Middle(PictureDifference d, int x, int y) => new
    {
        Column = x,
        Line = y,
        Row = d.Mine.Height - 1 - y,
        Mine = d.Mine[x, y],
        Reference = d.Reference[x, y],
    };

    private static object Measures(PictureDifference d) => new
    {
        Maximum = d.Largest,
        Mae = d.MeanAbsoluteError,
        Rmse = d.RootMeanSquareError,
    };

    private static object Recognised(Recognition r) => new
    {
        AgreesWhen = r.Change.Description,
        Turn = r.Change.Turn.ToString(),
        r.Change.Right,
        r.Change.Down,
        r.Change.Bytes,
        r.Change.SidesSwapped,
        r.Change.Channels,
        Verdict = ComparisonText.Of(r.Likeness),
        r.Difference.Wrong,
        r.Difference.OffByOne,
    };

    private static object Models(Scene scene, SceneDifference s) => new
    {
        ReferenceIsItsPicture = s.IsReferenceOwn,
        MineIsItsPicture = s.IsReferenceOwn ? (bool?)null : s.IsMineOwn,
        Models = s.Models.Select(model => new
        {
            model.Model,
            Name = NameOf(scene, model.Model),
            Type = TypeOf(scene, model.Model),
            model.Pixels,
            model.Wrong,
            model.Share,
            Missing = model.IsMissing,
            model.Color,
            model.OtherColor,
            Shows = model.Shows.Select(shown =>
                new { shown.Model, Name = NameOf(scene, shown.Model), Type = TypeOf(scene, shown.Model), shown.Pixels }),
        }),
    };

    private static object NameOf(Scene scene, int model) => model < 0 ? "background" : scene.Models[model].Name ?? JsonText.Null;

    private static string? TypeOf(Scene scene, int model) => model < 0 ? null : scene.Models[model].Kind;
}
