namespace RayCaster.Teaching.Visibility;

/// <summary>Makes the maps of a scene: numbers for each pixel instead of a colour.</summary>
public static class MapMaker
{
    /// <summary>The most pixels of a map. Making it needs up to about 35 bytes of memory for each pixel.</summary>
    public const int MaxPixels = 100_000_000;

    /// <summary>Casts all rays of a scene and makes a map of their hits.</summary>
    /// <param name="threads">How many threads cast rays; one per core if left out.</param>
    /// <exception cref="ProblemException">The map has more pixels than <see cref="MaxPixels"/>, or does not fit into this machine's
    /// memory.</exception>
    public static NumberMap Make(Scene scene, MapKind kind, int? threads = null)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var pixels = (long)width * height;
        if (pixels > MaxPixels)
            throw new ProblemException(FormattableString.Invariant(
                $"a map of {width} × {height} has {pixels:N0} pixels; the limit is {MaxPixels:N0}, for all of it is in memory at once"));
        try
        {
            var hits = new Renderer(scene, threads).CastHits();
            var map = new NumberMap(width, height);
            Parallel.For(0, height, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, y =>
            {
                for (var x = 0; x < width; x++) map[x, y] = Number(scene.Camera, hits, kind, x, y);
            });
            return map;
        }
        catch (OutOfMemoryException e)
        {
            throw new ProblemException($"there is not enough memory for a map of {width} × {height}", e);
        }
    }

    /// <summary>The number of a pixel, as <see cref="MapKind"/> describes it.</summary>
    private static float Number(Camera camera, HitMap hits, MapKind kind, int x, int y)
    {
        var pixel = y * hits.Width + x;
        return kind switch
        {
            MapKind.T => ToFloat(hits.T[pixel]),
            MapKind.Depth => ToFloat(hits.T[pixel] * -(camera.RayThrough(x, camera.Height - 1 - y).Direction * camera.W)),
            _ => hits.Model[pixel],
        };
    }

    /// <summary>Rounds to float. A finite number stays finite, because infinity means that nothing is hit.</summary>
    private static float ToFloat(double number) =>
        double.IsFinite(number) ? (float)Math.Clamp(number, float.MinValue, float.MaxValue) : (float)number;
}
