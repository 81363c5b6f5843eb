namespace RayCaster;

/// <summary>What all threads share that work on one picture: the models' views, and which of them may show in which tile.</summary>
internal sealed class Frame
{
    /// <summary>With fewer models a look at each of them is cheaper than a list for each tile.</summary>
    private const int FewModels = 64;

    /// <summary>
    /// Kernels that are made for one kind of shape each spare half of the time, but compiling them takes as long as casting some ten million rays. So they wait until
    /// the pictures of this process have had this many pixels.
    /// </summary>
    private const long PixelsOfLongWork = 1 << 24;

    private static long pixelsSoFar;

    private readonly int tilesAcross;
    private readonly int[] everywhere;               // models that show in a good part of the picture
    private readonly int[] starts = [], listed = []; // of tile i the models listed[starts[i]] … listed[starts[i + 1] − 1]

    /// <param name="scene">The scene.</param>
    /// <param name="threads">How many threads may prepare what a model needs.</param>
    /// <param name="isLong">Whether the work is long; found out if left out.</param>
    public Frame(Scene scene, int threads, bool? isLong = null)
    {
        Scene = scene;
        var camera = scene.Camera;
        IsLong = isLong ?? Interlocked.Add(ref pixelsSoFar, (long)camera.Width * camera.Height) >= PixelsOfLongWork;
        Views = new ModelView[scene.Models.Count];
        for (var i = 0; i < Views.Length; i++) Views[i] = scene.Models[i].See(camera, threads);

        Extents = Array.ConvertAll(Views, view => view.Extent);

        tilesAcross = TilesOf(camera.Width);
        var large = Views.Length <= FewModels ? -1 : Math.Max(1 << 16, (long)camera.Width * camera.Height / 16);
        var places = new List<int>();
        for (var i = 0; i < Views.Length; i++)
            if (Extents[i].Area > large)
                places.Add(i);
        everywhere = [.. places];
        if (everywhere.Length == Views.Length) return;

        // Counts first, then places: all lists in one array. The nearest come first in each, so that they hide the others early.
        var order = new int[Views.Length];
        for (var i = 0; i < order.Length; i++) order[i] = i;
        Array.Sort(Array.ConvertAll(Views, view => view.Nearest), order);
        starts = new int[tilesAcross * TilesOf(camera.Height) + 1];
        VisitTiles(order, large, (tile, _) => starts[tile + 1]++);
        for (var tile = 1; tile < starts.Length; tile++) starts[tile] += starts[tile - 1];
        listed = new int[starts[^1]];
        var next = starts[..^1];
        VisitTiles(order, large, (tile, i) => listed[next[tile]++] = i);
    }

    /// <summary>Whether it pays to compile a kernel for each kind of shape.</summary>
    public bool IsLong { get; }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The models' views, in the order of the scene.</summary>
    public ModelView[] Views { get; }

    /// <summary>Where in the picture each of them can show at all.</summary>
    public Tile[] Extents { get; }

    /// <summary>How many tiles lie side by side, or one upon another.</summary>
    public static int TilesOf(int pixels) => (pixels + Tile.MaxSide - 1) / Tile.MaxSide;

    /// <summary>How many strips lie side by side.</summary>
    public static int StripsOf(int pixels) => (pixels + Tile.MaxStrip - 1) / Tile.MaxStrip;

    /// <summary>The models that may show anywhere.</summary>
    public ReadOnlySpan<int> Everywhere => everywhere;

    /// <summary>The others that may show in a tile, the nearest first.</summary>
    public ReadOnlySpan<int> ListOf(in Tile tile)
    {
        if (starts.Length == 0) return [];
        var i = tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide;
        return listed.AsSpan(starts[i]..starts[i + 1]);
    }

    /// <summary>Visits the tiles of all models that are not large.</summary>
    private void VisitTiles(int[] order, long large, Action<int, int> visit)
    {
        foreach (var i in order)
        {
            var extent = Extents[i];
            if (extent.Area == 0 || extent.Area > large) continue;
            for (var row = extent.Row / Tile.MaxSide; row < TilesOf(extent.EndRow); row++)
                for (var column = extent.Column / Tile.MaxSide; column < TilesOf(extent.EndColumn); column++)
                    visit(row * tilesAcross + column, i);
        }
    }
}

/// <summary>A model that may show in a tile.</summary>
/// <param name="Index">Its place in the scene.</param>
/// <param name="Reach">Where its hits lie.</param>
internal readonly record struct Candidate(int Index, Reach Reach);
