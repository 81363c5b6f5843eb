using System.Text;

namespace RayCaster.Documents;

/// <summary>docs/mistakes.md and its pictures, made from the catalogue.</summary>
internal static class Gallery
{
    private const int SheetColumns = 10, ThumbWidth = 64, ThumbHeight = 40, SheetGap = 2;

    private static readonly (Concerns Concerns, string Title, string Lead)[] stages =
    [
        (Concerns.Camera, "From a pixel to its ray", "Camera, vectors, and where in a pixel a ray passes."),
        (Concerns.Hit, "Which hit shows", "Which crossings count, and which of them wins."),
        (Concerns.Spheres, "Spheres", ""),
        (Concerns.Planes, "Planes", ""),
        (Concerns.Boxes, "Boxes", ""),
        (Concerns.Circles, "Circles", ""),
        (Concerns.Triangles, "Triangles", "Those of meshes too."),
        (Concerns.Color, "From a hit to a colour", "Attenuation, and the way from a channel to its byte."),
        (Concerns.File, "From the pixels to the file", ""),
    ];

    /// <summary>The page.</summary>
    public static string File { get; } = ProjectFolder.PathOf("docs/mistakes.md");

    /// <summary>The sheet with all pictures.</summary>
    public static string SheetFile { get; } = ProjectFolder.PathOf("docs/mistakes/all.png");

    /// <summary>The picture of a mistake.</summary>
    public static string PictureOf(Mistake mistake) => ProjectFolder.PathOf($"docs/mistakes/{mistake.Id}.png");

    /// <summary>The mistakes in the order of the page.</summary>
    public static IEnumerable<Mistake> InOrder => stages.SelectMany(stage => Of(stage.Concerns));

    /// <summary>The text of the page.</summary>
    public static string Page()
    {
        var alike = Resemblance.OfAll();
        var page = new StringBuilder($"""
            # {MistakeCatalog.All.Count} mistakes, and what they look like

            Everybody who writes a ray caster makes some of these. The left half of each picture is right; the right half shows the mistake.
            Is one of them yours?

            ![All mistakes, one small picture each](mistakes/all.png)

            The first picture is right; the others follow row by row, in the order of the contents below. You need not search by eye:

                dotnet run --project src/RayCaster.Cli -- diagnose scenes/mistakes/generic.json mine.png

            says which of them your own program's picture `mine.png` shows. You choose how much of the mistake it reveals:
            `--hint symptom`, `question` or `answer` ([how it finds out](diagnosis.md)).
            On this page the questions and the answers are folded, so that you can look at the pictures first.
            Draw the five scenes of [scenes/mistakes](../scenes/mistakes) with your program: if all five are right, it has none of these mistakes.
            [How much of each scene a mistake changes](mistakes-table.md) is in a table.
            Each title of a slide leads to [where its formula stands](slides-to-code.md).

            This page is made from the [catalogue](../src/RayCaster.Teaching/Diagnoses/MistakeCatalog.cs),
            by `dotnet run --project tests/Documents`.

            ## Contents


            """);
        foreach (var (concerns, title, _) in stages)
            page.AppendLine($"- [{title}](#{Anchor(title)}): {string.Join(", ", Of(concerns).Select(Link))}");
        foreach (var (concerns, title, lead) in stages)
        {
            page.AppendLine().AppendLine($"## {title}");
            if (lead.Length > 0) page.AppendLine().AppendLine(lead);
            foreach (var mistake in Of(concerns)) Append(page, mistake, alike[mistake]);
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

    private static IEnumerable<Mistake> Of(Concerns concerns) => MistakeCatalog.All.Where(mistake => mistake.Concerns.HasFlag(concerns)
        && stages.First(stage => mistake.Concerns.HasFlag(stage.Concerns)).Concerns == concerns);

    private static void Append(StringBuilder page, Mistake mistake, Resemblance resemblance)
    {
        var showcase = Showcase.Of(mistake);
        var right = showcase.Tile();
        var isWithinRounding = Showcase.IsWithinRounding(right, showcase.Tile(mistake));
        page.AppendLine().AppendLine($"### {mistake.Id}").AppendLine()
            .Append($"![{(isWithinRounding ? "Right, and in which channels the wrong one differs" : "Right, and wrong")}]")
            .Append($"(mistakes/{mistake.Id}.png)<br><sub>[{showcase.Name}](../scenes/mistakes/{showcase.Name}.json)</sub>")
            .AppendLine().AppendLine()
            .AppendLine($"**{Markdown(Sentence(mistake.Cause))}** {Markdown(mistake.Hint.Symptom)}");
        if (isWithinRounding)
            page.AppendLine().AppendLine("The right half shows where a channel is off by its one level: the eye sees nothing of it.");
        if (resemblance.Alike.Count > 0)
            page.AppendLine().AppendLine($"Looks just like {List(resemblance.Alike)} in this scene.");
        if (resemblance.Near.Count > 0)
            page.AppendLine().AppendLine($"Looks {(resemblance.Alike.Count > 0 ? "nearly" : "much")} like {List(resemblance.Near)} in this scene.");
        page.AppendLine().AppendLine($"""
            <details><summary>A question</summary>

            {Markdown(mistake.Hint.Question)}

            </details>
            <details><summary>The answer</summary>

            {Markdown(mistake.Hint.Answer)}

            Slide: [{mistake.Slide}](slides-to-code.md)

            </details>
            """);
    }

    private static string List(IReadOnlyList<Mistake> mistakes) => string.Join(", ", mistakes.Select(Link));

    private static string Link(Mistake mistake) => $"[{mistake.Id}](#{mistake.Id})";

    private static string Anchor(string title) => title.ToLowerInvariant().Replace(' ', '-');

    /// <summary>A capital letter where the cause begins with a word, not with a formula.</summary>
    private static string Sentence(string cause) =>
        (char.IsLetter(cause[1]) || cause.StartsWith("a ", StringComparison.Ordinal) ? char.ToUpperInvariant(cause[0]) + cause[1..] : cause) + ".";

    private static string Markdown(string text) => text.Replace("|", "\\|").Replace("<", "&lt;").Replace("*", "\\*");

    /// <summary>The mean over the places of the large picture that each pixel of the small one covers.</summary>
    private static Picture Thumb(Picture tile)
    {
        var scale = Math.Max((double)tile.Width / ThumbWidth, (double)tile.Height / ThumbHeight);
        var thumb = new Picture((int)(tile.Width / scale), (int)(tile.Height / scale));
        const int n = 4;
        for (var y = 0; y < thumb.Height; y++)
        {
            for (var x = 0; x < thumb.Width; x++)
            {
                var (r, g, b) = (0, 0, 0);
                for (var i = 0; i < n * n; i++)
                {
                    var (left, top) = ((int)((x + (i % n + 0.5) / n) * scale), (int)((y + (i / n + 0.5) / n) * scale));
                    var pixel = tile[Math.Min(left, tile.Width - 1), Math.Min(top, tile.Height - 1)];
                    (r, g, b) = (r + pixel.R, g + pixel.G, b + pixel.B);
                }
                thumb[x, y] = ((byte)(r / (n * n)), (byte)(g / (n * n)), (byte)(b / (n * n)));
            }
        }
        return thumb;
    }
}
