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
            return Make(scene, kind, hits);
        }
        catch (OutOfMemoryException e)
        {
            throw new PictureFileException($"there is not enough memory for a map of {width} × {height}", e);
        }
    }

    /// <summary>Makes a map of hits that were found before.</summary>
    public static NumberMap Make(Scene scene, MapKind kind, HitMap hits)
    {
        var camera = scene.Camera;
        var map = new NumberMap(hits.Width, hits.Height, kind.Channels());
        var surfaces = kind.Channels() == 3 ? new SurfaceHits(scene, hits) : null;
        for (var y = 0; y < hits.Height; y++)
        {
            for (var x = 0; x < hits.Width; x++)
            {
                var numbers = map[x, y];
                var (place, row) = (y * hits.Width + x, hits.Height - 1 - y);
                switch (kind)
                {
                    case MapKind.T:
                        numbers[0] = ToFloat(hits.T[place]);
                        break;
                    case MapKind.Depth:
                        var d = camera.Direction<Scalar>(x, row);
                        numbers[0] = ToFloat(hits.T[place] * -(d * camera.W));
                        break;
                    case MapKind.Model:
                        numbers[0] = hits.Model[place];
                        break;
                    case MapKind.Normal:
                        var n = surfaces!.Normal(x, row);
                        (numbers[0], numbers[1], numbers[2]) = ((float)n.X, (float)n.Y, (float)n.Z);
                        break;
                    case MapKind.Uv:
                        var (u, v) = surfaces!.Parameters(x, row);
                        (numbers[0], numbers[1]) = (ToFloat(u), ToFloat(v));
                        break;
                }
            }
        }
        return map;
    }

    /// <summary>Rounds to float. A finite number stays finite, because infinity means that nothing is hit.</summary>
    private static float ToFloat(double number) =>
        double.IsFinite(number) ? (float)Math.Clamp(number, float.MinValue, float.MaxValue) : (float)number;
}
