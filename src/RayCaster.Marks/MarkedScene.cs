namespace RayCaster.Marks;

/// <summary>A scene that a class is marked by, with what all students share: its picture is drawn once.</summary>
/// <param name="Name">The scene file's name without its extension.</param>
/// <param name="Diagnoser">The scene, its picture, and the mistakes that show in it.</param>
internal sealed record MarkedScene(string Name, Diagnoser Diagnoser)
{
    public Scene Scene => Diagnoser.Scene;

    public Picture Right => Diagnoser.Right;

    /// <summary>Whether a mistake changes the picture. The first call tries all mistakes, which takes a second or two.</summary>
    public bool Shows(string mistake) => !Diagnoser.Hidden.Any(hidden => hidden.Id == mistake);

    /// <summary>Whether the picture needs a part of a program (<see cref="MissingPart.All"/>).</summary>
    public bool Needs(string part) =>
        Scene.Models.Any(model => model.Kind == part) || MistakeCatalog.DrawnWithout(part).Any(mistake => Shows(mistake.Id));
}
