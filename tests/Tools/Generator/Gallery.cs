namespace RayCaster.Generator;

/// <summary>docs/mistakes.md and its pictures, made from the catalogue.</summary>
internal static class Gallery
{
    private const int SheetColumns = 10, ThumbWidth = 64, ThumbHeight = 40, SheetGap = 2;

    private static readonly (Predicate<StepKind> Has, string Title)[] stages =
    [
        (StepKinds.IsOfRays, "From a pixel to its ray"),
        (StepKinds.IsOfHits, "Which hit shows"),
        (step => step == StepKind.Sphere, "Spheres"),
        (step => step == StepKind.Plane, "Planes"),
        (step => step == StepKind.Aabb, "Boxes"),
        (step => step == StepKind.Circle, "Circles"),
        (step => step == StepKind.Triangle, "Triangles, also those of meshes"),
        (StepKinds.IsOfColors, "From a hit to a colour"),
        (step => step == StepKind.File, "From the pixels to the file"),
    ];

    /// <summary>The page.</summary>
    public static string File { get; } = ProjectFolder.PathOf("docs/mistakes.md");

    /// <summary>The sheet with all pictures.</summary>
    public static string SheetFile { get; } = ProjectFolder.PathOf("docs/mistakes/all.png");

    /// <summary>The picture of a mistake.</summary>
    public static string PictureOf(Mistake mistake) => ProjectFolder.PathOf($"docs/mistakes/{mistake.Id}.png");

    /// <summary>The mistakes in the order of the page.</summary>
    public static IEnumerable<Mistake> InOrder => stages.SelectMany(stage => Of(stage.Has));

    /// <summary>The text of the page.</summary>
    public static string Page()
    {
        var initials = MistakeCatalog.All.ToDictionary(mistake => mistake, Initials);
        var hidden = string.Join(" and ", MistakeCatalog.All.Where(mistake => initials[mistake] == "–").Select(mistake => $"`{mistake.Id}`"));
        var page = new StringBuilder($"""
            # {MistakeCatalog.All.Count} mistakes, and what they look like

            Everybody who writes a ray caster makes some of these. In each picture the left half is right, and the right half shows the mistake.
            To find yours, draw [scenes/mistakes/generic.json](../scenes/mistakes/generic.json) with your own program and run

                dotnet run --project src/RayCaster.Cli -- diagnose scenes/mistakes/generic.json mine.png

            `--hint question` (the default) or `--hint answer` says more than this page ([how it works](diagnosis.md)).
            `dotnet run --project src/RayCaster.Cli -- wrong scenes/room.json rows+bgr` draws a wrong picture.

            The letters behind a mistake's name are the scenes of [scenes/mistakes](../scenes/mistakes) in which at least 20 pixels change by more
            than 2 levels: **g**eneric, **p**ortrait, **i**nside, **a**xis, **b**ubble. If your program draws all five right, it has none of these
            mistakes but perhaps {hidden}, which move a channel by one level.

            ![All mistakes, one small picture each, in the order of this page; the first picture is right](mistakes/all.png)

            `dotnet run --project tests/Tools/Generator` makes this page from the
            [catalogue](../src/RayCaster.Teaching/Changes/MistakeCatalog.cs).

            """);
        foreach (var (concerns, title) in stages)
        {
            page.AppendLine($"\n## {title}\n\nright, wrong | mistake | what you see\n---|---|---");
            foreach (var mistake in Of(concerns))
                page.AppendLine($"![{mistake.Id}](mistakes/{mistake.Id}.png) | `{mistake.Id}` ({initials[mistake]}): {Markdown(mistake.Cause)} "
                    + $"| {Markdown(mistake.Hint.Symptom)}");
        }
        return page.ToString().ReplaceLineEndings("\n");
    }

    /// <summary>The picture with a small picture of each mistake; the right one first.</summary>
    public static Picture Sheet()
    {
        Picture[] tiles = [Showcase.Whole[0].Tile(), .. InOrder.Select(mistake => Showcase.Of(mistake).Tile(mistake))];
        var rows = (tiles.Length + SheetColumns - 1) / SheetColumns;
        var sheet = Showcase.Blank(SheetColumns * (ThumbWidth + SheetGap) - SheetGap, rows * (ThumbHeight + SheetGap) - SheetGap);
        for (var i = 0; i < tiles.Length; i++)
        {
            var thumb = Thumb(tiles[i]);
            Showcase.Put(thumb, sheet, i % SheetColumns * (ThumbWidth + SheetGap) + (ThumbWidth - thumb.Width) / 2,
                i / SheetColumns * (ThumbHeight + SheetGap) + (ThumbHeight - thumb.Height) / 2);
        }
        return sheet;
    }

    private static IEnumerable<Mistake> Of(Predicate<StepKind> stage) => MistakeCatalog.All.Where(mistake =>
        stages.First(other => mistake.Steps.Any(step => other.Has(step))).Has == stage);

    /// <summary>The initials of the scenes that show a mistake.</summary>
    private static string Initials(Mistake mistake)
    {
        var shown = Showcase.ShownIn(mistake).Select(name => name[0]).ToArray();
        return shown.Length == 0 ? "–" : new(shown);
    }

    private static string Markdown(string text) => text.Replace("|", "\\|").Replace("<", "&lt;").Replace("*", "\\*");

    private static Picture Thumb(Picture tile)
    {
        var scale = Math.Max((double)tile.Width / ThumbWidth, (double)tile.Height / ThumbHeight);
        var (width, height) = ((int)(tile.Width / scale), (int)(tile.Height / scale));
        return Picture.Create(width, height, (x, y) => Mean(tile,
            x * tile.Width / width, (x + 1) * tile.Width / width, y * tile.Height / height, (y + 1) * tile.Height / height));
    }

    /// <summary>The mean colour of some columns and lines, of one at least.</summary>
    private static (byte, byte, byte) Mean(Picture picture, int left, int right, int top, int bottom)
    {
        (right, bottom) = (Math.Max(left + 1, right), Math.Max(top + 1, bottom));
        var (count, r, g, b) = ((right - left) * (bottom - top), 0, 0, 0);
        for (var y = top; y < bottom; y++)
            for (var x = left; x < right; x++)
            {
                var color = picture[x, y];
                r += color.R;
                g += color.G;
                b += color.B;
            }
        return (Rounded(r), Rounded(g), Rounded(b));

        byte Rounded(int sum) => (byte)((sum + count / 2) / count);
    }
}
