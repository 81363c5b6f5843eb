namespace RayCaster.Teaching;

/// <summary>A scene that a class is marked by, with what all submissions share: its picture is drawn once.</summary>
/// <param name="Name">The scene file's name without its extension.</param>
/// <param name="Path">The full path of the scene file.</param>
/// <param name="Text">The scene that programs draw: the file's, or a variation of it.</param>
/// <param name="Judge">The scene, its picture, and the mistakes that show in it.</param>
internal sealed record MarkedScene(string Name, string Path, ReadOnlyMemory<byte> Text, SceneDiagnosis Judge)
{
    public Scene Scene => Judge.Scene;

    public Picture Right => Judge.Right;

    /// <summary>The right picture of the scene that this is a variation of, which students may have; null if this is none.</summary>
    public Picture? Known { get; init; }

    /// <summary>Whether a mistake changes the picture. The first call tries all mistakes, which takes a second or two.</summary>
    public bool Shows(string mistake) => !Judge.Hidden.Any(hidden => hidden.Id == mistake);

    /// <summary>Whether the picture needs a part of a program (<see cref="Diagnosis.Parts"/>).</summary>
    public bool Needs(string part) =>
        Scene.Models.Any(model => model.Kind == part) || new Unfinished([part]).AsMistakes.Any(mistake => Shows(mistake.Id));

    /// <summary>The scene with other numbers; null if no variation was found.</summary>
    /// <param name="mayShowLess">Whether it need not show every mistake that the scene shows.</param>
    public MarkedScene? Varied(string seed, bool mayShowLess)
    {
        var folder = System.IO.Path.GetDirectoryName(Path)!;
        return SceneVariation.Of(Text, folder, seed, folder, mayShowLess: mayShowLess) is { } text
            && SceneReader.Parse(text, Path, folder).Scene is { } scene
            ? this with { Text = text, Judge = new(scene), Known = Right } : null;
    }
}
