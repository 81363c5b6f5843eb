using RayCaster.Teaching.Tests.Mistakes;

namespace RayCaster.Generator;

/// <summary>What part of which scene shows a mistake best.</summary>
/// <param name="Name">The scene, in scenes/mistakes.</param>
/// <param name="Width">How wide the whole scene would be drawn; its own proportions are kept.</param>
/// <param name="X">The first column of the tile in that picture.</param>
/// <param name="Y">The first line of the tile in that picture.</param>
/// <param name="Zoom">How many pixels of the tile make one of the picture's.</param>
internal sealed record Showcase(string Name, int Width, int X = 0, int Y = 0, int Zoom = 1)
{
    /// <summary>The size of a tile, if the scene is not smaller.</summary>
    public const int TileWidth = 128, TileHeight = 80;

    private const int Gap = 3;

    /// <summary>Differences that the eye sees.</summary>
    private const int VisibleLevels = 2;

    /// <summary>A mistake that changes fewer pixels is not visible.</summary>
    private const int VisiblePixels = 20;

    /// <summary>Where the whole of the generic scene does not do.</summary>
    private static readonly Dictionary<string, Showcase> chosen = new()
    {
        ["center"] = new("generic", 64, 12, 6, Zoom: 4),
        ["wm1"] = new("generic", 64, 32, 0, Zoom: 4),
        ["row-off"] = new("generic", 64, 12, 6, Zoom: 4),
        ["aspect-int"] = new("portrait", 80),
        ["w-unnorm"] = new("inside", TileWidth),
        ["len-nosqrt"] = new("axis", TileWidth),
        ["dir-unnorm"] = new("inside", TileWidth),
        ["att-depth"] = new("inside", TileWidth),
        ["last-hit"] = new("generic", 192, 0, 30),
        ["zfar-t"] = new("portrait", 160, 32, 0),
        ["znear-t"] = new("generic", 256, 128, 0),
        ["zboth-t"] = new("generic", 192, 64, 0),
        ["bias-big"] = new("generic", 240, 112, 0),
        ["clip-root"] = new("portrait", 200, 14, 232),
        ["far-root"] = new("generic", 192, 30, 35),
        ["near-root-only"] = new("inside", TileWidth),
        ["slab-noswap"] = new("axis", TileWidth),
        ["slab-tmax"] = new("axis", TileWidth),
        ["slab-inv-nan"] = new("axis", 64, 16, 10, Zoom: 4),
        ["circ-nosq"] = new("generic", 320, 192, 73),
        ["tri-cull"] = new("generic", 320, 33, 16),
        ["tri-area"] = new("portrait", 250, 122, 170),
        ["noclamp"] = new("generic", 240, 112, 8),
    };

    private static readonly Dictionary<string, Scene> scenes = SceneFolder.Files("scenes/mistakes")
        .ToDictionary(file => Path.GetFileNameWithoutExtension(file), SceneFolder.Read);

    private static readonly Dictionary<string, Picture> right =
        scenes.ToDictionary(scene => scene.Key, scene => MistakeCatalog.Draw(scene.Value, []));

    /// <summary>All scenes that show mistakes, the one that shows most first.</summary>
    public static IReadOnlyList<Showcase> Whole { get; } =
        [new("generic", TileWidth), new("portrait", 80), new("inside", TileWidth), new("axis", TileWidth), new("bubble", TileWidth)];

    /// <summary>The part that was chosen for a mistake, or the whole of the first scene that shows it.</summary>
    public static Showcase Of(Mistake mistake) =>
        chosen.GetValueOrDefault(mistake.Id) ?? Whole.FirstOrDefault(showcase => showcase.Shows(mistake)) ?? Whole[0];

    /// <summary>The scenes, each in its own size, that show a mistake.</summary>
    public static IEnumerable<string> ShownIn(Mistake mistake) => Whole.Select(showcase => showcase.Name).Where(name =>
        ChangedPixels.Count(right[name], MistakeCatalog.Draw(scenes[name], [mistake]), VisibleLevels) >= VisiblePixels);

    /// <summary>The scene at the size that it is drawn with.</summary>
    public Scene Scene
    {
        get
        {
            var scene = scenes[Name];
            var height = (int)Math.Round((double)Width * scene.Camera.Height / scene.Camera.Width);
            return scene.WithSize(Width, height);
        }
    }

    /// <summary>The right tile, a white line, and beside it the wrong one; of a mistake within rounding, where it changes a channel.</summary>
    public Picture Draw(Mistake mistake)
    {
        var (right, wrong) = (Tile(), Tile(mistake));
        if (IsWithinRounding(right, wrong)) wrong = Difference(right, wrong);
        var both = Blank(right.Width + Gap + wrong.Width, Math.Max(right.Height, wrong.Height));
        Put(right, both, 0, 0);
        Put(wrong, both, right.Width + Gap, 0);
        return both;
    }

    /// <summary>The tile, drawn with mistakes or without.</summary>
    public Picture Tile(params Mistake[] mistakes)
    {
        var whole = MistakeCatalog.Draw(Scene, mistakes);
        var (width, height) = (Math.Min(TileWidth, Zoom * (whole.Width - X)), Math.Min(TileHeight, Zoom * (whole.Height - Y)));
        if (X == 0 && Y == 0 && Zoom == 1) return whole; // which may be upright
        var tile = new Picture(width, height);
        for (var y = 0; y < height; y++)
            for (var x = 0; x < width; x++) tile[x, y] = whole[X + x / Zoom, Y + y / Zoom];
        return tile;
    }

    /// <summary>Whether pictures differ nowhere by more than a level.</summary>
    public static bool IsWithinRounding(Picture right, Picture wrong) => ChangedPixels.Count(right, wrong, levels: 1) == 0;

    /// <summary>A picture in white.</summary>
    public static Picture Blank(int width, int height)
    {
        var picture = new Picture(width, height);
        Array.Fill(picture.Rgb, (byte)255);
        return picture;
    }

    /// <summary>Puts one picture into another.</summary>
    public static void Put(Picture small, Picture large, int left, int top)
    {
        for (var y = 0; y < small.Height; y++)
            for (var x = 0; x < small.Width; x++) large[left + x, top + y] = small[x, y];
    }

    private static Picture Difference(Picture a, Picture b)
    {
        var picture = new Picture(a.Width, a.Height);
        for (var i = 0; i < picture.Rgb.Length; i++) picture.Rgb[i] = (byte)(a.Rgb[i] == b.Rgb[i] ? 0 : 255);
        return picture;
    }

    private bool Shows(Mistake mistake)
    {
        var (right, wrong) = (Tile(), Tile(mistake));
        return (right.Width, right.Height) != (wrong.Width, wrong.Height)
            || ChangedPixels.Count(right, wrong, VisibleLevels) >= 0.01 * right.Width * right.Height;
    }
}
