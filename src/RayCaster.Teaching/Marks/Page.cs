using System.Text.Encodings.Web;
using System.Text.Unicode;

namespace RayCaster.Teaching;

/// <summary>An HTML page in one file: it contains its pictures and its style, and needs no network.</summary>
internal sealed class Page(string title)
{
    private const string Style = """
        body { font: 16px/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff; }
        h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2rem; }
        table { border-collapse: collapse; width: 100%; }
        td, th { border-bottom: 1px solid #ddd; padding: .3rem .6rem; text-align: left; vertical-align: top; }
        td.n, th.n { text-align: right; } td.n { white-space: nowrap; } .wide { overflow-x: auto; } .wide th, .wide td { padding: .3rem .4rem; }
        .wide td:last-child { min-width: 10rem; }
        td.long, p { overflow-wrap: anywhere; }
        tr.lost td { background: #fff1ee; } tr.undecided td { background: #fff8dd; }
        .beside { min-width: 20rem; } .beside img { max-width: 48%; vertical-align: top; } tr, .beside, .slid { break-inside: avoid; }
        .small { color: #555; font-size: .9rem; } img { image-rendering: pixelated; }
        .slid { display: inline-block; } .pair { position: relative; line-height: 0; max-width: 100%; border: 1px solid #999; }
        .pair img { max-width: 100%; } .pair img + img { position: absolute; left: 0; top: 0; clip-path: inset(0 0 0 var(--at, 50%)); }
        .pair::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--at, 50%);
          border-left: 2px solid #fff; mix-blend-mode: difference; }
        input[type=range] { display: block; width: 100%; margin: 0; }
        @media print, (scripting: none) { .pair img + img { position: static; clip-path: none; } input[type=range] { display: none; }
          .pair::after { border: 0; } }
        """;

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

    /// <summary>Text, escaped for an element or an attribute.</summary>
    public static string Escaped(string text) => encoder.Encode(text);

    /// <summary>The head of a column.</summary>
    public static string Head(string text, bool isOfNumbers = false) =>
        $"<th scope=\"col\"{(isOfNumbers ? " class=\"n\"" : "")}>{Escaped(text)}</th>";

    /// <summary>A picture inside the page.</summary>
    /// <param name="words">A description for people who cannot see it.</param>
    public static string Image(Picture picture, string words)
    {
        using var png = new MemoryStream();
        PictureFile.Write(png, picture, PictureFormat.Png);
        return $"<img alt=\"{Escaped(words)}\" src=\"data:image/png;base64,{Convert.ToBase64String(png.ToArray())}\">";
    }

    public override string ToString() => $"""
        <!DOCTYPE html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width">
        <title>{Escaped(title)}</title>
        <style>
        {Style}
        </style>
        </head>
        <body>
        <h1>{Escaped(title)}</h1>
        {body}</body>
        </html>

        """;
}
