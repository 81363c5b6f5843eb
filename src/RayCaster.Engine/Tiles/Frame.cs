namespace RayCaster.Engine;

/// <summary>What all threads share that work on one picture: the models as the camera sees them, each by itself or as one of a crowd.</summary>
internal sealed class Frame : IDisposable
{
    /// <summary>With fewer models a look at each of them is cheaper than a list for each part of the picture.</summary>
    private const int FewModels = 64;

    /// <summary>
    /// Kernels that are made for one kind of shape each spare half of the time, but compiling them takes as long as casting some ten million rays. They are used for a
    /// picture of at least so many pixels, or where many pictures follow each other.
    /// </summary>
    private const long PixelsOfLongWork = 1 << 24;

    /// <param name="scene">The scene.</param>
    /// <param name="threads">How many threads may prepare what a model needs.</param>
    /// <param name="manyFrames">Whether many pictures follow each other.</param>
    public Frame(Scene scene, int threads, bool manyFrames)
    {
        Scene = scene;
        var camera = scene.Camera;
        IsLong = manyFrames || (long)camera.Width * camera.Height >= PixelsOfLongWork;
        var (models, alone) = (scene.Models, new List<int>());
        if (models.Count > FewModels && !camera.IsSkewed) Crowd = new(camera, models.Count);
        for (var i = 0; i < models.Count; i++)
            if (Crowd is null || !Crowd.Add(models[i], i))
                alone.Add(i);
        if (Crowd is not null) alone.AddRange(Crowd.Arrange(threads));

        Places = [.. alone];
        Views = Array.ConvertAll(Places, i => ViewMaker.See(models[i], camera, threads));
        Extents = Array.ConvertAll(Views, view => view.Extent);
    }

    /// <summary>Whether it pays to compile a kernel for each kind of shape.</summary>
    public bool IsLong { get; }

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

    /// <summary>Turns hits into bytes; made when it is first asked for.</summary>
    public SpanShader Shader => field ??= new(Scene, IsLong);

    /// <summary>Gives rented memory back when the picture is done.</summary>
    public void Dispose()
    {
        foreach (var view in Views) view.Free();
        Crowd?.Free();
    }
}
