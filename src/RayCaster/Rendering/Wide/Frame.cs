namespace RayCaster;

/// <summary>What all threads share that work on one picture: the models' views, and which of them may show in which tile.</summary>
internal sealed class Frame
{
    /// <summary>With fewer models a look at each of them is cheaper than a list for each tile.</summary>
    private const int FewModels = 64;

    private readonly int tilesAcross;
    private readonly int[] everywhere;               // models that show in a good part of the picture
    private readonly int[] starts = [], listed = []; // of tile i the models listed[starts[i]] … listed[starts[i + 1] − 1]

    public Frame(Scene scene)
    {
        Scene = scene;
        var camera = scene.Camera;
        Views = new ModelView[scene.Models.Count];
        for (var i = 0; i < Views.Length; i++) Views[i] = scene.Models[i].See(camera);

        tilesAcross = TilesOf(camera.Width);
        var tiles = tilesAcross * TilesOf(camera.Height);
        var all = new int[Views.Length];
        for (var i = 0; i < all.Length; i++) all[i] = i;
        if (Views.Length <= FewModels)
        {
            everywhere = all;
            return;
        }

        everywhere = Array.FindAll(all, i => IsLarge(i));
        starts = new int[tiles + 1];
        foreach (var i in all)
            if (!IsLarge(i))
                ForTilesOf(Views[i].Extent, tile => starts[tile + 1]++);
        for (var tile = 0; tile < tiles; tile++) starts[tile + 1] += starts[tile];
        listed = new int[starts[tiles]];
        var next = starts.AsSpan(0, tiles).ToArray();
        foreach (var i in all)
            if (!IsLarge(i))
                ForTilesOf(Views[i].Extent, tile => listed[next[tile]++] = i);

        bool IsLarge(int i) => (long)Views[i].Extent.Width * Views[i].Extent.Height > Math.Max(1 << 16, (long)camera.Width * camera.Height / 16);
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The models' views, in the order of the scene.</summary>
    public ModelView[] Views { get; }

    /// <summary>How many tiles lie side by side, or one upon another.</summary>
    public static int TilesOf(int pixels) => (pixels + Tile.MaxSide - 1) / Tile.MaxSide;

    /// <summary>Adds the models that may show in a tile, in the order of the scene.</summary>
    public void AddModelsOf(in Tile tile, List<Candidate> candidates)
    {
        ReadOnlySpan<int> some = [];
        if (starts.Length > 0)
        {
            var i = tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide;
            some = listed.AsSpan(starts[i]..starts[i + 1]);
        }
        foreach (var large in everywhere)
        {
            for (; some.Length > 0 && some[0] < large; some = some[1..]) candidates.Add(new(some[0], Reach.Unknown));
            candidates.Add(new(large, Reach.Unknown));
        }
        foreach (var rest in some) candidates.Add(new(rest, Reach.Unknown));
    }

    private void ForTilesOf(Tile extent, Action<int> act)
    {
        if (extent.Width <= 0 || extent.Height <= 0) return;
        for (var row = extent.Row / Tile.MaxSide; row < TilesOf(extent.EndRow); row++)
            for (var column = extent.Column / Tile.MaxSide; column < TilesOf(extent.EndColumn); column++)
                act(row * tilesAcross + column);
    }
}

/// <summary>A model that may show in a tile.</summary>
/// <param name="Index">Its place in the scene.</param>
/// <param name="Reach">Where its hits lie.</param>
internal readonly record struct Candidate(int Index, Reach Reach);
