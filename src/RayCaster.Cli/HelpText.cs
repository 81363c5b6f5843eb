namespace RayCaster.Cli;

internal static class HelpText
{
    /// <summary>Shown without arguments: the one command to try.</summary>
    public const string Usage = """
        raycaster draws a scene: it casts one ray for each pixel and writes the picture.
        Try:   dotnet run --project src/RayCaster.Cli -- scenes/first.json
        More:  dotnet run --project src/RayCaster.Cli -- help

        """;

    /// <summary>Shown after a wrong command line: the usage of its command, and how to read more.</summary>
    public static string HintAfter(string[] arguments)
    {
        if (Command.NameIn(arguments) is not { } name) return "Try 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.\n";
        var help = Command.All[name]().Help;
        var usage = help.AsSpan(help.IndexOf("Usage:", StringComparison.Ordinal));
        return $"{usage[..usage.IndexOf("\n\n")]}\nTry 'raycaster help {name}', or dotnet run --project src/RayCaster.Cli -- help {name}.\n";
    }

    public const string Full = """
        Description:
          Draws a scene: casts one ray for each pixel and writes the picture.

        Usage:
          raycaster [draw] <scene> [options]
          raycaster <command> ...

        For students:
          live <scene>                     Opens a page that redraws the scene when you save it.
          diagnose <scene> <mine>          Names the mistake that makes a picture wrong.
          compare <mine> <reference>       Says whether two pictures are the same, and where not.
          explain <scene> <column> <line>  Shows how one pixel gets its colour.

        For teachers:
          handout <folder>                 Writes the lab for students: ten steps, with tests.
          mark <rubric> <submissions>      Marks a class by its pictures, with a page for each.
          vary <scene>                     Makes a similar scene, one for each student.
          check <scene>...                 Finds errors, and mistakes that a scene cannot show.

        For large pictures and many:
          stitch <part>...                 Joins parts into one picture, or lists missing lines.
          orbit <scene>                    Draws the frames of a moving camera.
          animate <frame>...               Joins frames into an animated PNG.
          sheet <picture>...               Draws small copies of many pictures on one sheet.

          help [command]                   Shows this help, or a command's.

        Arguments:
          <scene>  The scene file (JSON); "-" reads it from standard input.

        Options:
          -o, --output <file>    Where to write the picture: .png or .ppm; "-" writes it to a
                                 redirected standard output, as PPM.
                                 [default: the scene's name with .png, in the current folder]
              --format <format>  png, ppm or ppm-text (PPM in readable numbers).
                                 [default: by the file's extension]
          -s, --size <W>x<H>     Overrides the scene's picture size, in pixels.
              --rows <lines>     Draws only these lines of the picture, a part for "stitch": for
                                 example 0..249 (counted from 0 at the top, both included), or
                                 3/8 (the third of eight parts).
                                 [default output: room.part-0000-0249.png]
              --resume           Does nothing if a complete picture or part of the same scene
                                 exists already.
          -t, --threads <n>      How many threads cast rays. [default: one per core]
              --map <kind>       Writes numbers instead of the picture: t, depth, model, normal
                                 or uv. The files are <scene>.<kind>.pfm and a picture, .png.
              --mistake <ids>    Draws the picture of a program with a mistake, or with several,
                                 for example rows+bgr. docs/mistakes.md lists the mistakes.
              --ledger           Prints which models show, and why the others do not. Also
                                 printed if the picture is empty or has one colour.
              --plain            Draws by the definition, ScalarRenderer, ray by ray: for the
                                 debugger and for Console.WriteLine in a formula.
              --preview          Also shows the picture in the terminal (standard output).
              --color <when>     Colours of the preview: auto, always or never. [default: auto,
                                 which uses NO_COLOR, FORCE_COLOR, COLORTERM and TERM]
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.
              --version          Shows the version.
          -?, -h, --help         Shows this help. Under "dotnet run" write it after "--".

        Examples:
          dotnet run --project src/RayCaster.Cli -- scenes/room.json
          dotnet run --project src/RayCaster.Cli -- scenes/room.json -o room.ppm --size 1920x1080

        Exit codes:
          0 done, 1 the answer is no (pictures differ, parts are missing), 2 failed,
          70 internal error, 129 hung up, 130 interrupted, 143 terminated.

        """;
}
