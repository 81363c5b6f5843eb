namespace RayCaster.Cli;

/// <summary>What the console app says of itself.</summary>
internal static class HelpText
{
    /// <summary>For a start without arguments: the one command to try.</summary>
    public const string Usage = """
        raycaster casts one ray per pixel through a scene file and writes the picture.
        Try:   dotnet run --project src/RayCaster.Cli -- scenes/first.json
        More:  dotnet run --project src/RayCaster.Cli -- help

        """;

    /// <summary>For those who ask.</summary>
    public const string Full = """
        Description:
          Casts one ray per pixel through a scene file and writes the picture.

        Usage:
          raycaster <scene> [options]
          raycaster <command> ...

        For students:
          live <scene>                     Opens a page that follows the scene file.
          diagnose <scene> <mine>          Says which mistake makes a wrong picture.
          compare <mine> <reference>       Says whether two pictures are the same, and where not.
          explain <scene> <column> <line>  Shows how one pixel gets its colour.

        For teachers:
          handout <folder>                 Writes the lab for students: ten steps, with tests.
          mark <rubric> <submissions>      Marks a class by its pictures, with a page for each.
          vary <scene>                     Makes a scene of its own for each student.
          check <scene>...                 Finds errors, and what a scene's picture cannot show.

        For large pictures and many:
          stitch <part>...                 Joins parts into one picture; says which are missing.
          orbit <scene>                    Draws the frames of a camera that moves.
          animate <frame>...               Joins frames into an animated PNG.
          sheet <picture>...               Shows many pictures, made small, on one.

          help [command]                   Shows this help, or a command's.

        Arguments:
          <scene>  The scene file (JSON); "-" reads it from standard input.

        Options:
          -o, --output <file>    Where to write the picture: .png or .ppm; "-" writes it to a
                                 redirected standard output, as PPM.
                                 [default: the scene's name with .png, in the current folder]
              --format <format>  png, ppm or ppm-text (PPM in readable numbers).
                                 [default: what the file's extension says]
          -s, --size <W>x<H>     Overrides the scene's picture size, in pixels.
              --rows <lines>     Draws only these lines of the picture, a part for "stitch": as
                                 0..249 (from the top, 0 first, both included), or as 3/8 (the
                                 third of eight parts). [default output: room.part-0000-0249.png]
              --resume           Does nothing if the picture or part is there already, whole
                                 and of this very scene.
          -t, --threads <n>      How many threads cast rays. [default: one per core]
              --map <kind>       Writes numbers in place of the picture: t, depth, model, normal
                                 or uv, as <scene>.<kind>.pfm, and to look at as .png.
              --mistake <ids>    Draws the picture of a program with this mistake, or with
                                 several at once, as rows+bgr; docs/mistakes.md lists them.
              --ledger           Prints which models show, and why the others do not. Printed
                                 by itself when the picture is empty or of one colour.
              --plain            Draws by the definition, ScalarRenderer, ray by ray: for the
                                 debugger and for Console.WriteLine in a formula.
              --preview          Shows the picture in the terminal, too (standard output).
              --color <when>     Colours of the preview: auto, always or never. [default: auto,
                                 which heeds NO_COLOR, FORCE_COLOR, COLORTERM and TERM]
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.
              --version          Shows the version.
          -?, -h, --help         Shows this help. Under "dotnet run" write it after "--".

        Examples:
          dotnet run --project src/RayCaster.Cli -- scenes/room.json
          dotnet run --project src/RayCaster.Cli -- scenes/room.json -o room.ppm --size 1920x1080

        Exit codes:
          0 done, 1 the answer is no (pictures differ, parts are missing), 2 could not do it,
          70 internal error, 129 hung up, 130 interrupted, 143 terminated.

        """;
}
