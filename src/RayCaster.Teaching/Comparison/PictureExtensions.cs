namespace RayCaster.Teaching.Comparison;

/// <summary>More members of scenes and pictures.</summary>
public static class PictureExtensions
{
    /// <summary>By how many levels the pixels of a picture may differ that has nearly one colour.</summary>
    private const int NearlyEqual = 2;

    /// <param name="scene">Any scene.</param>
    extension(Scene scene)
    {
        /// <summary>The bytes of a pixel, by its index in reading order.</summary>
        internal (byte R, byte G, byte B) BytesAt(HitMap hits, int pixel) => scene.Shade(hits[pixel]).ToBytes();

        /// <summary>The picture of hits.</summary>
        internal Picture PictureOf(HitMap hits) => Picture.Create(hits.Width, hits.Height, (x, y) => scene.BytesAt(hits, y * hits.Width + x));
    }

    /// <param name="picture">Any picture.</param>
    extension(Picture picture)
    {
        /// <summary>A picture of pixels that a function gives for each column and line.</summary>
        internal static Picture Create(int width, int height, Func<int, int, (byte R, byte G, byte B)> pixel)
        {
            var made = new Picture(width, height);
            for (var y = 0; y < height; y++)
                for (var x = 0; x < width; x++) made[x, y] = pixel(x, y);
            return made;
        }

        /// <summary>A pixel by its index in reading order.</summary>
        internal (byte R, byte G, byte B) At(int pixel) => (picture.Rgb[3 * pixel], picture.Rgb[3 * pixel + 1], picture.Rgb[3 * pixel + 2]);

        /// <summary>How many pixels it has.</summary>
        public int Count => picture.Width * picture.Height;

        /// <summary>Whether all pixels are equal, so that the picture proves nothing.</summary>
        public bool IsOneColor => picture.Rgb.AsSpan(3).SequenceEqual(picture.Rgb.AsSpan(0, picture.Rgb.Length - 3));

        /// <summary>Whether all pixels are equal but for a level or two: such a picture proves as little.</summary>
        internal bool IsNearlyOneColor
        {
            get
            {
                for (var channel = 0; channel < 3; channel++)
                {
                    var (least, most) = (byte.MaxValue, byte.MinValue);
                    for (var i = channel; i < picture.Rgb.Length; i += 3)
                    {
                        (least, most) = (Math.Min(least, picture.Rgb[i]), Math.Max(most, picture.Rgb[i]));
                        if (most - least > NearlyEqual) return false;
                    }
                }
                return true;
            }
        }

        /// <summary>The one colour of a picture in words: <c>black, (0, 0, 0)</c>.</summary>
        internal string OneColorInWords
        {
            get
            {
                var color = picture.At(picture.Count / 2);
                var word = picture.IsOneColor && color == default ? "black, " : picture.IsOneColor && color == (255, 255, 255) ? "white, " : "";
                return $"{word}{color}{(picture.IsOneColor ? "" : ", but for a level or two")}";
            }
        }
    }
}
