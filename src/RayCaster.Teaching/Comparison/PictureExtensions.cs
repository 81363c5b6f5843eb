namespace RayCaster.Teaching.Comparison;

/// <summary>More members of scenes, meshes and pictures.</summary>
internal static class PictureExtensions
{
    private static readonly ConditionalWeakTable<Mesh, TriangleTree> trees = [];

    extension(Mesh mesh)
    {
        /// <summary>Its hierarchy, built at the first use.</summary>
        public TriangleTree Tree => trees.GetValue(mesh, static mesh => new(mesh.Vertices, mesh.Indices));
    }

    extension(Scene scene)
    {
        /// <summary>The bytes of a pixel, by its index in reading order.</summary>
        public (byte R, byte G, byte B) BytesAt(HitMap hits, int pixel) => scene.Shade(hits[pixel]).ToBytes();
    }

    extension(Picture picture)
    {
        /// <summary>A picture of pixels that a function gives for each column and line.</summary>
        public static Picture Of(int width, int height, Func<int, int, (byte R, byte G, byte B)> pixel)
        {
            var made = new Picture(width, height);
            for (var y = 0; y < height; y++)
                for (var x = 0; x < width; x++) made[x, y] = pixel(x, y);
            return made;
        }

        /// <summary>A pixel by its index in reading order.</summary>
        public (byte R, byte G, byte B) At(int pixel) => (picture.Rgb[3 * pixel], picture.Rgb[3 * pixel + 1], picture.Rgb[3 * pixel + 2]);

        public int Count => picture.Width * picture.Height;

        /// <summary>Whether all pixels are equal, so that the picture proves nothing.</summary>
        public bool IsOneColor => picture.Rgb.AsSpan(3).SequenceEqual(picture.Rgb.AsSpan(0, picture.Rgb.Length - 3));
    }
}
