namespace RayCaster.Cli;

internal sealed class WrongCommand() : Command("wrong", "<scene> <ids>", "Draws a wrong picture, with known mistakes.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the picture: .png or .ppm. [default: <scene>.<ids>.png]");

    public static string[] Ids => [.. MistakeCatalog.All.Select(mistake => mistake.Id)];

    public override string Description =>
        "Draws the picture of a program with one known mistake or several, for exams and to test a rubric.";

    public override IReadOnlyList<(string, string)> Arguments =>
        [Scene, ("<ids>", "The mistakes, for example r-nosq, or rows+bgr for two. docs/mistakes.md lists them.")];

    public override Option[] Options => [output, Option.Format, Option.Size, Option.Threads, Option.Quiet];

    public override string[] Examples => ["wrong scenes/room.json r-nosq -o mine.png"];

    public override int Run(CommandLine line)
    {
        var operands = line.Exactly("<scene>", "<ids>");
        if (Option.ReadList(operands[1], '+', Ids) is not { } ids) throw ProblemException.Usage("no mistake is named: docs/mistakes.md lists them");
        var file = line.Get(output) ?? $"{SceneInput.NameOf(operands[0])}.{string.Join('+', ids)}.png";
        var format = PictureOutput.FormatOf(file, line.Get(Option.Format));
        var scene = SceneInput.Read(operands[0], line, judges: true);
        PictureFile.ThrowIfTooLarge(scene.Camera.Width, scene.Camera.Height); // it is in memory at once

        foreach (var id in ids.Where(id => !MutationCoverage.CanTry(scene, MistakeCatalog.Named(id)!)))
            line.Warn($"{id}: a large mesh is drawn rightly all the same; draw its triangles as models to see the mistake");
        var mistakes = Array.ConvertAll(ids, id => MistakeCatalog.Named(id)!.Usual);
        PictureOutput.Write(file, Draw(), format);
        line.Tell($"{OutputFile.NameOf(file)}: wrong on purpose: {string.Join("; ", mistakes.Select(mistake => mistake.Cause))}");
        return ExitCode.Done;

        Picture Draw()
        {
            try
            {
                return MistakeCatalog.Draw(scene, mistakes, line.Get(Option.Threads));
            }
            catch (ArgumentException e) when (e.ParamName == "mistakes")
            {
                throw ProblemException.Usage($"{operands[1]}: two of these mistakes are in the same part of a formula, so no program has both");
            }
        }
    }
}
