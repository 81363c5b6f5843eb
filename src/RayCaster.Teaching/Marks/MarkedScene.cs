namespace RayCaster.Teaching;

/// <summary>A scene that a class is marked by, and what all its submissions share: the right picture is drawn once.</summary>
internal sealed class MarkedScene
{
    private readonly Lazy<HashSet<string>> hidden;

    /// <param name="name">The scene file's name without its extension.</param>
    /// <param name="path">The full path of the scene file.</param>
    /// <param name="scene">The scene.</param>
    public MarkedScene(string name, string path, Scene scene)
    {
        (Name, Path, Scene) = (name, path, scene);
        Right = Renderer.Render(scene);
        Places = new GoldenSteps(Right.Width * Right.Height);
        hidden = new(() => [.. SceneFitness.HiddenIn(scene, null).Select(mistake => mistake.Id)]);
    }

    /// <summary>The scene file's name without its extension.</summary>
    public string Name { get; }

    /// <summary>The full path of the scene file.</summary>
    public string Path { get; }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>Its picture.</summary>
    public Picture Right { get; }

    /// <summary>The pixels in an order whose every beginning is spread over the whole picture.</summary>
    public GoldenSteps Places { get; }

    /// <summary>
    /// Whether the picture of a program with this mistake looks otherwise; tried once for all mistakes, which takes a second or two.
    /// </summary>
    public bool Shows(string mistake) => !hidden.Value.Contains(mistake);
}
