namespace RayCaster.Teaching;

/// <summary>Makes the maps of a scene: numbers for each pixel instead of a colour.</summary>
public static class MapMaker
{
    /// <summary>The most pixels of a map. Making it needs up to about 35 bytes of memory for each pixel.</summary>
    public const int MostPixels = 100_000_000;

    /// <summary>Casts all rays of a scene and makes a map of their hits.</summary>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    /// <exception cref="PictureFileException">The map has more pixels than <see cref="MostPixels"/>, or does not fit into this machine's
    /// memory.</exception>
    public static NumberMap Make(Scene scene, MapKind kind, int? threads = null)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var pixels = (long)width * height;
        if (pixels > MostPixels)
            throw new PictureFileException(FormattableString.Invariant(
                $"a map of {width} × {height} has {pixels:N0} pixels; the limit is {MostPixels:N0}, for all of it is in memory at once"));
        try
        {
            var hits = new Renderer(scene, threads).CastHits();
            var map = new NumberMap(width, height, kind.Channels());
            var surfaces = kind.Channels() == 3 ? new SurfaceHits(scene, hits) : null;
            Parallel.For(0, height, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, y =>
            {
                for (var x = 0; x < width; x++)
                {
                    var numbers = Numbers(scene, kind, hits, surfaces, x, y);
                    map[x, y][0] = ToFloat(numbers.X);
                    if (surfaces is not null) (map[x, y][1], map[x, y][2]) = (ToFloat(numbers.Y), ToFloat(numbers.Z));
                }
            });
            return map;
        }
        catch (OutOfMemoryException e)
        {
            throw new PictureFileException($"there is not enough memory for a map of {width} × {height}", e);
        }
    }

    private static Vector3 Numbers(Scene scene, MapKind kind, HitMap hits, SurfaceHits? surfaces, int x, int y)
    {
        var (place, row) = (y * hits.Width + x, hits.Height - 1 - y);
        return kind switch
        {
            MapKind.T => new(hits.T[place], 0, 0),
            MapKind.Depth => new(hits.T[place] * -(scene.Camera.Direction<Scalar>(x, row) * scene.Camera.W), 0, 0),
            MapKind.Model => new(hits.Model[place], 0, 0),
            MapKind.Normal => surfaces!.Normal(x, row),
            _ => surfaces!.Parameters(x, row),
        };
    }

    /// <summary>Rounds to float. A finite number stays finite, because infinity means that nothing is hit.</summary>
    private static float ToFloat(double number) =>
        double.IsFinite(number) ? (float)Math.Clamp(number, float.MinValue, float.MaxValue) : (float)number;
}
