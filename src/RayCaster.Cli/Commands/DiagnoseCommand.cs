namespace RayCaster.Cli;

internal sealed class DiagnoseCommand() : Command("diagnose", "<scene> <mine>", "Names the mistake that makes a picture wrong.")
{
    private static readonly Option<HintLevel?> hint = new("--hint", "<level>",
        "How much to show: symptom (what you see), question (what to ask yourself) or answer (what is wrong, and the slide). [default: question]",
        "symptom, question or answer",
        text => text switch { "symptom" => HintLevel.Symptom, "question" => HintLevel.Question, "answer" => HintLevel.Answer, _ => null });
    private static readonly Option<string[]> parts = Option.List("--done", "<parts>",
        "What your program draws already, for example plane,sphere: plane, sphere, aabb, circle, triangle, mesh, attenuation, clipping. " +
        "If one of these does not show, that is a mistake; other parts may be missing.", MissingPart.All);
    private static readonly Option<bool> asJson = Option.Switch("--json", "Prints everything as JSON, also the answers and errors.");

    public override string Description =>
        "Finds out why a picture is wrong: what the program does not draw yet, or which mistake it has. Draws the scene with each known mistake, " +
        "and with pairs of mistakes, and names the one whose picture is most similar.";

    public override IReadOnlyList<(string, string)> Arguments =>
        [("<scene>", "The scene file."), ("<mine>", "The picture that your program drew of it: PNG, PGM or PPM.")];

    public override Option[] Options => [hint, parts, Option.Everything, asJson, Option.Threads];

    public override string[] Examples => ["diagnose scenes/room.json mine.png", "diagnose scenes/room.json mine.png --hint answer"];

    public override string ExitCodes =>
        "0 the picture is right, 1 it is wrong (or has another size than the scene), 2 failed. All known mistakes, with pictures: docs/mistakes.md.";

    public override int Run(CommandLine line)
    {
        try
        {
            return Diagnose(line);
        }
        catch (Exception e) when (line.Get(asJson) && e is ProblemException or ReportedException)
        {
            StandardStreams.WriteOutput(DiagnosisReport.Json(e.Message)); // other programs read standard output, also after an error
            throw;
        }
    }

    private static int Diagnose(CommandLine line)
    {
        var operands = line.Exactly("<scene>", "<mine>");
        var scenePath = operands[0];
        var picturePath = operands[1];
        var level = line.Get(hint) ?? HintLevel.Question;
        var json = line.Get(asJson);
        var scene = SceneInput.Read(scenePath, line, warns: false, judges: true);
        var picture = PictureFile.Read(picturePath, StandardStreams.WriteError);
        var size = (scene.Camera.Width, scene.Camera.Height);
        var hasOtherSize = !Diagnoser.CanJudge(scene, picture);
        if (hasOtherSize)
        {
            StandardStreams.WriteError(
                $"{picturePath} is {picture.Width} x {picture.Height}, not the scene's {size.Width} x {size.Height} pixels: " +
                "it is compared with the scene drawn in that size");
            scene = scene.WithSize(picture.Width, picture.Height);
        }
        var budget = line.Budget();
        var prepared = new Diagnoser(scene, line.Get(Option.Threads), budget: budget, size: size);
        var diagnosis = prepared.Diagnose(picture, line.Get(parts) ?? CarriedTool.WrittenParts());
        var hidden = diagnosis.Kind == DiagnosisKind.Matches ? prepared.Hidden : [];
        var mayChange = diagnosis.IsOpen || diagnosis.Kind == DiagnosisKind.Matches; // after a match it may be the mistakes that cannot show
        if (mayChange && budget?.UsedUp is { } limit) line.Warn($"Not everything was tried within {limit}; --all tries everything.");
        StandardStreams.WriteOutput(json
            ? DiagnosisReport.Json(diagnosis, (picture.Width, picture.Height), size, hidden, line.Warning)
            : DiagnosisReport.Text(diagnosis, picturePath, scenePath, level)
                + (diagnosis.Kind == DiagnosisKind.Matches ? DiagnosisReport.HiddenText(prepared) : "") + MoreHelp(diagnosis, level));
        return diagnosis.Kind == DiagnosisKind.Matches && !hasOtherSize ? ExitCode.Done : ExitCode.No;
    }

    private static string MoreHelp(DiagnosisResult diagnosis, HintLevel level) => diagnosis.Kind != DiagnosisKind.Mistake ? "" : level switch
    {
        HintLevel.Symptom => "\nMore help: --hint question, or --hint answer\n",
        HintLevel.Question => "\nMore help: --hint answer\n",
        _ => "",
    };
}
