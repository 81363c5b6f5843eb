namespace RayCaster.Teaching;

/// <summary>Where two pictures differ, put together from single pixels.</summary>
public static class WrongArea
{
    /// <summary>A pixel in the middle of the largest area in which the pictures differ by more than rounding; null where there is none.</summary>
    public static (int X, int Y)? MiddleOfLargest(PictureDifference difference)
    {
        var (width, height) = (difference.Mine.Width, difference.Mine.Height);
        var seen = new bool[width * height];
        var (area, largest) = (new List<int>(), new List<int>());
        for (var pixel = 0; pixel < seen.Length; pixel++)
        {
            Spread(difference, pixel, seen, area);
            if (area.Count > largest.Count) (area, largest) = (largest, area);
        }
        if (largest.Count == 0) return null;
        var (x, y) = (largest.Average(pixel => pixel % width), largest.Average(pixel => pixel / width));
        var middle = largest.MinBy(pixel => Math.Pow(pixel % width - x, 2) + Math.Pow(pixel / width - y, 2)); // a ring has no pixel in its middle
        return (middle % width, middle / width);
    }

    /// <summary>Each model in one colour: the larger the share of its pixels that are wrong, the hotter. Black if the pictures were not compared
    /// model by model.</summary>
    public static Picture ByObject(PictureComparison comparison)
    {
        var picture = new Picture(comparison.Reference.Width, comparison.Reference.Height);
        if (comparison.ByModels is not { } byModels) return picture;
        var colors = byModels.Models.ToDictionary(model => model.Model, model => HeatMap.Of((int)Math.Ceiling(255 * model.Share)));
        for (var i = 0; i < picture.Width * picture.Height; i++)
            picture[i % picture.Width, i / picture.Width] = colors.GetValueOrDefault(byModels.ModelAt(i));
        return picture;
    }

    /// <summary>Lists the wrong pixels that hang together with one.</summary>
    private static void Spread(PictureDifference difference, int start, bool[] seen, List<int> area)
    {
        var (width, height) = (difference.Mine.Width, difference.Mine.Height);
        area.Clear();
        Add(start % width, start / width);
        for (var next = 0; next < area.Count; next++)
        {
            var (x, y) = (area[next] % width, area[next] / width);
            Add(x - 1, y);
            Add(x + 1, y);
            Add(x, y - 1);
            Add(x, y + 1);
        }

        void Add(int x, int y)
        {
            if (x < 0 || y < 0 || x >= width || y >= height || seen[y * width + x] || difference.LevelsAt(x, y) <= 1) return;
            seen[y * width + x] = true;
            area.Add(y * width + x);
        }
    }
}
