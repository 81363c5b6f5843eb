namespace RayCaster.Engine;

/// <summary>The models of a picture as the camera sees them, each by itself or as one of a batch.</summary>
internal sealed class Frame<N> : Frame where N : struct, IPacket<N>
{
    /// <summary>With fewer models, testing each of them is cheaper than lists for parts of the picture.</summary>
    private const int FewModels = 64;

    /// <inheritdoc cref="Frame.Of"/>
    public Frame(Scene scene, int threads, bool manyFrames) : base(scene, threads, manyFrames)
    {
        var camera = scene.Camera;
        var models = scene.Models;
        if (models.Count > FewModels && !camera.IsSkewed)
            PrimitiveBatch = new(camera, ShapeLists.Of(models, manyFrames, threads), models.Count, threads);
        Places = PrimitiveBatch is null ? new int[models.Count] : [.. PrimitiveBatch.Others];
        for (var i = 0; PrimitiveBatch is null && i < models.Count; i++) Places[i] = i;
        Views = Array.ConvertAll(Places, i => ViewMaker<N>.Of(models[i], camera, manyFrames, threads));
        Extents = Array.ConvertAll(Views, view => view.Extent);
    }

    /// <summary>Views of the models that are not in the batch.</summary>
    public ModelView[] Views { get; }

    public int[] Places { get; }

    /// <summary>Where in the picture each of them can show at all.</summary>
    public Tile[] Extents { get; }

    /// <summary>The other models; null if there are few.</summary>
    public PrimitiveBatch<N>? PrimitiveBatch { get; }

    public override IStripCaster NewCaster(bool isPlain) =>
        isPlain && !IsLong && PrimitiveBatch is null ? new PlainCaster<N>(this) : NewTileCaster();

    public override IHitConsumer HitsInto(HitMap map) => new HitMapConsumer<N>(map, Scene.Camera);

    public override void Dispose()
    {
        foreach (var view in Views) view.Free();
        PrimitiveBatch?.Free();
    }

    /// <remarks>A method of its own, so that the tile caster's code is not loaded if it is not needed.</remarks>
    private IStripCaster NewTileCaster() => new TileCaster<N>(this);
}
