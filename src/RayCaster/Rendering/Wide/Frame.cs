namespace RayCaster;

/// <summary>What all threads share that work on one picture: the models as the camera sees them, each by itself or as one of a crowd.</summary>
internal sealed class Frame : IDisposable
{
    /// <summary>With fewer models a look at each of them is cheaper than a list for each part of the picture.</summary>
    private const int FewModels = 64;

    /// <param name="scene">The scene.</param>
    /// <param name="threads">How many threads may prepare what a model needs.</param>
    public Frame(Scene scene, int threads)
    {
        Scene = scene;
        var models = scene.Models;
        var alone = new List<int>();
        if (models.Count > FewModels) Crowd = new(scene.Camera, models.Count);
        for (var i = 0; i < models.Count; i++)
            if (Crowd is null || !models[i].Join(Crowd, i))
                alone.Add(i);
        if (Crowd is not null) alone.AddRange(Crowd.Arrange());

        Places = [.. alone];
        Views = Array.ConvertAll(Places, i => models[i].See(scene.Camera, threads));
        Extents = Array.ConvertAll(Views, view => view.Extent);
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>Views of the models that are looked at one by one.</summary>
    public ModelView[] Views { get; }

    /// <summary>The places of these models in the scene.</summary>
    public int[] Places { get; }

    /// <summary>Where in the picture each of them can show at all.</summary>
    public Tile[] Extents { get; }

    /// <summary>The other models; null where there are few.</summary>
    public Crowd? Crowd { get; }

    /// <summary>Gives lent memory back when the picture is done.</summary>
    public void Dispose() => Crowd?.Free();

    /// <summary>How many tiles lie side by side, or one upon another.</summary>
    public static int TilesOf(int pixels) => (pixels + Tile.MaxSide - 1) / Tile.MaxSide;
}
