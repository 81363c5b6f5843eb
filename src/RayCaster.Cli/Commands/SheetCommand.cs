namespace RayCaster.Cli;

internal sealed class SheetCommand : Command
{
    public override string Help => """
        Description:
          Makes a contact sheet: one picture with small copies of many pictures.

        Usage:
          raycaster sheet <picture>... -o <file> [options]

        Arguments:
          <picture>...  PNG files, in order. The files of a pattern or a folder come in the order
                        of their names.

        Options:
          -o, --output <file>  The sheet, a .png.
              --columns <n>    How many copies in a row. [default: about as many as rows]
          -s, --size <W>x<H>   Size of each small picture, in pixels.
                               [default: at most 160 wide, in proportion to the first]
          -q, --quiet          Prints errors only.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var output = AnimateCommand.OutputOf(line, "sheet");
        var pictures = AnimateCommand.FramesOf(line, output);
        var columns = line.Count(Option.Columns, "columns", Camera.MaxSide) ?? (int)Math.Ceiling(Math.Sqrt(pictures.Count));
        var (width, height) = line.PictureSize() ?? ContactSheet.SizeFor(pictures[0]);
        var sheet = new ContactSheet(pictures, Math.Min(columns, pictures.Count), width, height);
        if (sheet.Width > Camera.MaxSide || sheet.Height > Camera.MaxSide || 3 * sheet.Width * (height + ContactSheet.Gap) > Array.MaxLength)
            throw new ProblemException($"a sheet of {sheet.Width} x {sheet.Height} pixels is too large: " +
                "make its pictures smaller with --size");
        PictureOutput.Write(output, cancellation, stream =>
        {
            using var writer = PictureWriter.Create(PictureFormat.Png, stream, (int)sheet.Width, (int)sheet.Height);
            sheet.Write(writer, cancellation);
            writer.Finish();
        });
        line.Tell($"{output}: {Digits.Count(pictures.Count, "picture")}, {sheet.Width} x {sheet.Height} pixels");
        return ExitCode.Done;
    }
}
