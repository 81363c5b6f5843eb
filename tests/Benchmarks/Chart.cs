using System.Globalization;
using System.Text;

namespace RayCaster.Benchmarks;

/// <summary>What a line of a chart stands for; each has a colour that the colour-blind can tell from the others, and a mark.</summary>
internal enum Ink
{
    Exact,
    Bytes,
    Embree,
    Naive,
    Scalar,
}

/// <summary>A line chart as SVG, for light and dark pages.</summary>
/// <param name="file">The file's name without extension.</param>
/// <param name="title">What it shows.</param>
/// <param name="xTitle">The axis to the right.</param>
/// <param name="yTitle">The axis upwards.</param>
/// <param name="logarithmic">Whether both axes go in powers of ten; otherwise in whole numbers from 0.</param>
internal sealed class Chart(string file, string title, string xTitle, string yTitle, bool logarithmic = true)
{
    private const int Width = 760, Height = 460, Left = 74, Top = 58, Right = 206, Bottom = 58;
    private const int PlotWidth = Width - Left - Right, PlotHeight = Height - Top - Bottom;

    // The attributes of the elements are the light page; a viewer that knows no style sheets shows that.
    private const string Style = """
        <style>
        @media (prefers-color-scheme: dark) {
          .page { fill: #0d1117; } .text { fill: #e6edf3; } .quiet { fill: #9da7b3; } .grid { stroke: #30363d; } .axis { stroke: #9da7b3; }
          .exact { color: #58a6e8; } .bytes { color: #2fc299; } .embree { color: #ff9248; } .naive { color: #d2a3cc; } .scalar { color: #9da7b3; }
        }
        </style>
        """;

    private readonly List<Line> lines = [];
    private (double Low, double High) x, y;

    private sealed record Line(string Name, Ink Ink, bool Dashed)
    {
        public List<(double X, double Y)> Points { get; } = [];
    }

    public string File { get; } = file;

    public string Title { get; } = title;

    /// <summary>Adds a point to the line of that name.</summary>
    public void Add(string name, Ink ink, double atX, double atY, bool dashed = false)
    {
        var line = lines.Find(line => line.Name == name);
        if (line is null) lines.Add(line = new(name, ink, dashed));
        line.Points.Add((atX, atY));
    }

    public string ToSvg()
    {
        x = Range(lines.SelectMany(line => line.Points).Select(p => p.X));
        y = Range(lines.SelectMany(line => line.Points).Select(p => p.Y));
        var svg = new StringBuilder();
        svg.AppendLine(Invariant($"""
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {Width} {Height}" width="{Width}" height="{Height}" role="img" aria-label="{Title}">
            {Style}
            <rect class="page" fill="#ffffff" width="{Width}" height="{Height}" rx="6"/>
            <g font-family="system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif" font-size="13">
            <text class="text" fill="#24292f" x="{Left}" y="28" font-size="16" font-weight="600">{Title}</text>
            <text class="quiet" fill="#57606a" x="{Left}" y="48">{yTitle}</text>
            <text class="quiet" fill="#57606a" x="{Left + PlotWidth / 2}" y="{Height - 16}" text-anchor="middle">{xTitle}</text>
            """));
        foreach (var tick in Ticks(x))
        {
            svg.AppendLine(Invariant(
                $"""<line class="grid" stroke="#d0d7de" x1="{AtX(tick):0.0}" y1="{Top}" x2="{AtX(tick):0.0}" y2="{Top + PlotHeight}"/>"""));
            svg.AppendLine(Invariant(
                $"""<text class="quiet" fill="#57606a" x="{AtX(tick):0.0}" y="{Top + PlotHeight + 20}" """) + Invariant(
                $"""text-anchor="middle">{Label(tick)}</text>"""));
        }
        foreach (var tick in Ticks(y))
        {
            svg.AppendLine(Invariant(
                $"""<line class="grid" stroke="#d0d7de" x1="{Left}" y1="{AtY(tick):0.0}" x2="{Left + PlotWidth}" y2="{AtY(tick):0.0}"/>"""));
            svg.AppendLine(Invariant(
                $"""<text class="quiet" fill="#57606a" x="{Left - 8}" y="{AtY(tick) + 4:0.0}" text-anchor="end">{Label(tick)}</text>"""));
        }
        svg.AppendLine(Invariant($"""<path class="axis" stroke="#57606a" fill="none" d="M{Left} {Top}V{Top + PlotHeight}H{Left + PlotWidth}"/>"""));
        for (var i = 0; i < lines.Count; i++)
        {
            var line = lines[i];
            var points = line.Points.OrderBy(p => p.X).Select(p => (X: AtX(p.X), Y: AtY(p.Y))).ToList();
            var legend = (X: Left + PlotWidth + 18, Y: Top + 10 + 24 * i);
            svg.AppendLine($"""<g class="{line.Ink.ToString().ToLowerInvariant()}" color="{LightColor(line.Ink)}">""");
            var stroke = "fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\" stroke-linejoin=\"round\"" +
                (line.Dashed ? " stroke-dasharray=\"6 4\"" : "");
            svg.AppendLine(Invariant($"""<path {stroke} d="M{string.Join("L", points.Select(p => Invariant($"{p.X:0.0} {p.Y:0.0}")))}"/>"""));
            svg.AppendLine(Invariant($"""<path {stroke} d="M{legend.X} {legend.Y}h28"/>"""));
            foreach (var p in points.Append((legend.X + 14, legend.Y))) svg.AppendLine(Mark(line.Ink, p.X, p.Y));
            svg.AppendLine("</g>");
            svg.AppendLine(Invariant($"""<text class="text" fill="#24292f" x="{legend.X + 36}" y="{legend.Y + 4}">{line.Name}</text>"""));
        }
        return svg.AppendLine("</g>\n</svg>").ToString();
    }

    private static string LightColor(Ink ink) => ink switch
    {
        Ink.Exact => "#0072b2",
        Ink.Bytes => "#008060",
        Ink.Embree => "#c85000",
        Ink.Naive => "#8a5a83",
        _ => "#6e7781",
    };

    private static string Mark(Ink ink, double x, double y) => ink switch
    {
        Ink.Exact => Invariant($"""<circle fill="currentColor" cx="{x:0.0}" cy="{y:0.0}" r="4"/>"""),
        Ink.Bytes => Invariant($"""<path fill="currentColor" d="M{x:0.0} {y - 5:0.0}l5 5l-5 5l-5 -5z"/>"""),
        Ink.Embree => Invariant($"""<rect fill="currentColor" x="{x - 4:0.0}" y="{y - 4:0.0}" width="8" height="8"/>"""),
        Ink.Naive => Invariant($"""<path fill="currentColor" d="M{x:0.0} {y - 5:0.0}l5 9h-10z"/>"""),
        _ => Invariant($"""<path fill="currentColor" d="M{x:0.0} {y + 5:0.0}l5 -9h-10z"/>"""),
    };

    private (double Low, double High) Range(IEnumerable<double> numbers)
    {
        var all = numbers.ToList();
        if (!logarithmic) return (0, Math.Ceiling(all.Max()));
        return (Math.Pow(10, Math.Floor(Math.Log10(all.Min()))), Math.Pow(10, Math.Ceiling(Math.Log10(all.Max()))));
    }

    private IEnumerable<double> Ticks((double Low, double High) range)
    {
        if (logarithmic)
        {
            for (var tick = range.Low; tick <= range.High * 1.001; tick *= 10) yield return tick;
            yield break;
        }
        var step = Math.Max(1, Math.Ceiling(range.High / 8));
        for (var tick = 0.0; tick <= range.High; tick += step) yield return tick;
    }

    private double AtX(double value) => Left + PlotWidth * Part(value, x);

    private double AtY(double value) => Top + PlotHeight * (1 - Part(value, y));

    private double Part(double value, (double Low, double High) range) => logarithmic
        ? Math.Log(value / range.Low) / Math.Log(range.High / range.Low)
        : (value - range.Low) / (range.High - range.Low);

    /// <summary>10, 100, 1000 as they are, then powers of ten.</summary>
    private static string Label(double tick)
    {
        if (tick is < 10_000 and > 0.005 || tick == 0) return tick.ToString("0.###", CultureInfo.InvariantCulture);
        const string Superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        var power = (int)Math.Round(Math.Log10(tick));
        return "10" + (power < 0 ? "⁻" : "") +
            string.Concat(Math.Abs(power).ToString(CultureInfo.InvariantCulture).Select(digit => Superscripts[digit - '0']));
    }

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
