using System.Text.Encodings.Web;
using System.Text.Unicode;

namespace RayCaster.Marks;

/// <summary>An HTML page in one file: it contains its pictures and its style, and needs no network.</summary>
internal sealed class Page(string title)
{
    private static readonly HtmlEncoder encoder = HtmlEncoder.Create(UnicodeRanges.All);

    private readonly StringBuilder body = new();

    public Page Html(string html)
    {
        body.Append(html).Append('\n');
        return this;
    }

    /// <summary>Adds an element with text, which is escaped.</summary>
    public Page Element(string name, string text, string? style = null) =>
        Html($"<{name}{(style is null ? "" : $" class=\"{style}\"")}>{Escaped(text)}</{name}>");

    /// <summary>Adds a heading and a table; nothing if there are no rows.</summary>
    /// <param name="rows">The rows as HTML.</param>
    public Page Table(string heading, IEnumerable<string> columns, IReadOnlyCollection<string> rows) => rows.Count == 0 ? this
        : Element("h2", heading).Html($"<div class=\"wide\"><table><tr>" +
            $"{string.Concat(columns.Select(column => $"<th scope=\"col\">{Escaped(column)}</th>"))}</tr>\n" +
            $"{string.Join('\n', rows)}\n</table></div>");

    /// <summary>Text, escaped for an element or an attribute.</summary>
    public static string Escaped(string text) => encoder.Encode(text);

    /// <summary>A picture inside the page.</summary>
    /// <param name="words">A description for people who cannot see it.</param>
    public static string Image(Picture picture, string words)
    {
        using var png = new MemoryStream();
        PictureFile.Write(png, picture, PictureFormat.Png);
        return $"<img alt=\"{Escaped(words)}\" src=\"data:image/png;base64,{Convert.ToBase64String(png.ToArray())}\">";
    }

    public override string ToString()
    {
        using var style = new StreamReader(typeof(Page).Assembly.GetManifestResourceStream("page.css")!);
        return $"""
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width">
            <title>{Escaped(title)}</title>
            <style>
            {style.ReadToEnd()}</style>
            </head>
            <body>
            <h1>{Escaped(title)}</h1>
            {body}</body>
            </html>

            """;
    }
}
