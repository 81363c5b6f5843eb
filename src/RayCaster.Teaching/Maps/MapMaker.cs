namespace RayCaster.Teaching;

/// <summary>Makes the maps of a scene: numbers for each pixel instead of a colour.</summary>
public static class MapMaker
{
    /// <summary>The most pixels of a map. All of it is in memory, with what it is made of up to some 35 bytes a pixel.</summary>
    public const int MostPixels = 100_000_000;

    /// <summary>Casts all rays of a scene and writes down what they find.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="kind">What to write down.</param>
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

    /// <summary>The same from rays that have been cast.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="kind">What to write down.</param>
    /// <param name="hits">What the scene's pixels hit.</param>
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

    /// <summary>Rounds; a finite number stays finite, for infinite means that nothing is hit.</summary>
    private static float ToFloat(double number) =>
        double.IsFinite(number) ? (float)Math.Clamp(number, float.MinValue, float.MaxValue) : (float)number;
}
