namespace RayCaster.Cli;

internal sealed class ModelsCommand() : Command("models", "<scene>", "Says which models show, and why the others do not.")
{
    public override string Description =>
        "Says, model by model, in how many pixels of a scene's picture it shows, and why it does not in the others: it is hidden by a " +
        "nearer one, behind the camera, nearer than zNear or beyond zFar. Also printed if a picture shows nothing, or one colour.";

    public override Option[] Options => [Option.Size, Option.Quiet];

    public override string[] Examples => ["models scenes/room.json"];

    public override int Run(CommandLine line)
    {
        var scene = SceneInput.Read(line.Exactly("<scene>")[0], line);
        StandardStreams.WriteOutput(SceneVisibility.Take(scene).Report());
        return ExitCode.Done;
    }

    /// <summary>The same, for a picture that looks like a mistake, unless it takes long.</summary>
    public static string WhyNothingShows(Scene scene) =>
        SceneVisibility.IsQuick(scene) ? SceneVisibility.Take(scene).Report()
        : "The picture shows nothing, or one colour. The command 'models' says why, which takes a while with so many triangles.";
}
