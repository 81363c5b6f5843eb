namespace RayCaster.Cli;

/// <summary>Starts the live page. It is a separate program, because a web server would make this one start more slowly.</summary>
internal sealed class LiveCommand() : Command("live", "<scene>", "Opens a page that redraws the scene when you save it.")
{
    public override string Description =>
        "Opens a page on this machine that shows a scene's picture and draws it again when you save the scene file. Drag to turn the camera; " +
        "click a pixel to read how it got its colour. In a clone \"dotnet run --project src/RayCaster.Live -- <scene>\" does the same.";

    public override IReadOnlyList<(string, string)> Arguments => [("<scene>", "The scene file (JSON).")];

    public override Option[] Options => LiveOptions.All;

    public override string[] Examples => ["live scenes/room.json"];

    public override int Run(CommandLine line)
    {
        line.Exactly("<scene>");
        return Programs.Run([Path.Join(CarriedTool.FolderOfPage(), CarriedTool.Page), LiveOptions.UntilInputEnds.Name, .. line.Words]);
    }
}
