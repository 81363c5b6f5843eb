namespace RayCaster.Cli;

internal sealed class PartCommand() : Command("part", "<scene> <lines>", "Draws some lines of a picture that is too large for one run.")
{
    /// <summary>The option of commands that can go on where they were interrupted.</summary>
    public static readonly Option<bool> Resume = Option.Switch("--resume",
        "Does not draw again what exists already, complete and of the same scene.");

    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the part, a .png. [default: for example room.part-0000-0249.png]");

    public override string Description =>
        "Draws some lines of a scene's picture, here or on many machines; \"stitch\" joins such parts. A part is a PNG that records what it shows.";

    public override IReadOnlyList<(string, string)> Arguments =>
    [
        Scene,
        ("<lines>", "The first and the last as in 0..249, counted from 0 at the top, or 3/8 for the third of eight equal parts."),
    ];

    public override Option[] Options => [output, Option.Size, Resume, Option.Threads, Option.Quiet];

    public override string[] Examples =>
        ["part scenes/room.json 1/2 --size 20000x20000", "part scenes/room.json 2/2 --size 20000x20000", "stitch room.part-*.png -o room.png"];

    public override int Run(CommandLine line)
    {
        var operands = line.Exactly("<scene>", "<lines>");
        if (RangeOf(operands[1]) is null)
            throw ProblemException.Usage($"'{operands[1]}' names no lines: " +
                "write the first and the last as in 0..249, counted from 0 at the top, or 3/8 for the third of eight parts");
        if (line.Get(output) is { } given && PictureOutput.FormatOf(given, null) != PictureFormat.Png)
            throw ProblemException.Usage("a part is a PNG file, which records what it shows; choose another name");
        var scene = SceneInput.Read(operands[0], line);

        var height = scene.Camera.Height;
        var lines = RangeOf(operands[1], height)
            ?? throw new ProblemException($"there is no part {operands[1]} of a picture of {height} lines, 0..{height - 1}");
        var file = line.Get(output) ?? $"{SceneInput.NameOf(operands[0])}.part-" +
            $"{Padded(lines.First, height)}-{Padded(lines.Last, height)}.png";
        var start = Stopwatch.GetTimestamp();
        var part = PartFacts.Create(scene, lines, SceneDigest.OfModels(scene.Models), typeof(Renderer).Assembly);
        if (line.Get(Resume) && IsUpToDate(file, part, line.Get(Option.Quiet)))
        {
            line.Tell($"{file}: exists already");
            return ExitCode.Done;
        }
        var drawing = new Drawing(scene, line);
        drawing.Write(file, PictureFormat.Png, part);
        var which = lines.Count == height ? "" : $"lines {lines} of ";
        line.Tell(drawing.Summary(file, lines.Count, Stopwatch.GetElapsedTime(start), which));
        return ExitCode.Done;
    }

    /// <summary>Some lines of a picture, or some frames: the first and the last, both included, as in 0..249, or a share, as in 3/8.</summary>
    /// <param name="count">How many there are in all; by default more than any picture has.</param>
    /// <returns>Null for any other text, and if there are not all of them, or fewer than parts.</returns>
    /// <exception cref="ProblemException">It is a share that does not exist, as 9/8.</exception>
    public static NumberRange? RangeOf(string text, long count = 1L << 31)
    {
        if (NumberRange.Parse(text) is { } range) return range.Last < count ? range : null;
        if (text.Split('/') is not [var k, var n] || Option.ReadCount(n) is not { } parts
            || !long.TryParse(k, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var part)) return null;
        if (part < 1 || part > parts)
            throw ProblemException.Usage($"there is no part {text}: parts are 1/{parts} to {parts}/{parts} (--array=1-{parts})");
        return parts <= count ? new((int)((part - 1) * count / parts), (int)(part * count / parts) - 1) : null;
    }

    /// <summary>Whether the picture exists already and need not be drawn. If a file exists but has other content, prints why it is drawn
    /// again.</summary>
    public static bool IsUpToDate(string output, PartFacts part, bool quiet)
    {
        if (PartFile.Holds(output, part, out var reason)) return true;
        if (reason is not null && !quiet) StandardStreams.WriteError($"{output} is drawn again: {reason}");
        return false;
    }

    /// <summary>A number of 0 to count − 1 for a file's name: all have one length, so the files sort in order.</summary>
    public static string Padded(int number, int count) => number.ToString($"D{Math.Max(4, $"{count - 1}".Length)}");
}
