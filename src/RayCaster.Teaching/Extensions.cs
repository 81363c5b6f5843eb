using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>What scenes, meshes and pictures show, and what texts for people share.</summary>
internal static class Extensions
{
    private static readonly ConditionalWeakTable<Mesh, TriangleTree> trees = [];

    extension(Mesh mesh)
    {
        /// <summary>Its hierarchy, built at the first use.</summary>
        public TriangleTree Tree => trees.GetValue(mesh, static mesh => new(mesh.Vertices, mesh.Indices));
    }

    extension(Scene scene)
    {
        /// <summary>How many shapes there are; each triangle of a mesh counts.</summary>
        public long ShapeCount => scene.Models.Sum(model => model is Mesh mesh ? mesh.TriangleCount : 1L);

        /// <summary>The bytes of a pixel, by its place in reading order.</summary>
        public (byte R, byte G, byte B) BytesAt(HitMap hits, int pixel) =>
            scene.Shade(hits.T[pixel], hits.Model[pixel] < 0 ? null : scene.Models[hits.Model[pixel]]).ToBytes();
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

        /// <summary>A pixel by its place in reading order.</summary>
        public (byte R, byte G, byte B) At(int place) => (picture.Rgb[3 * place], picture.Rgb[3 * place + 1], picture.Rgb[3 * place + 2]);

        public int Count => picture.Width * picture.Height;

        /// <summary>Whether all pixels are equal, so that the picture proves nothing.</summary>
        public bool IsOneColor => picture.Rgb.AsSpan(3).SequenceEqual(picture.Rgb.AsSpan(0, picture.Rgb.Length - 3));

        /// <summary>Whether a pixel or one of its eight neighbours has a colour, but for two levels.</summary>
        public bool ShowsAround(int x, int y, (byte R, byte G, byte B) color)
        {
            for (var j = Math.Max(0, y - 1); j <= Math.Min(picture.Height - 1, y + 1); j++)
                for (var i = Math.Max(0, x - 1); i <= Math.Min(picture.Width - 1, x + 1); i++)
                    if (PictureDifference.Levels(color, picture[i, j]) <= Evidence.Tolerance) return true;
            return false;
        }

        /// <summary>Whether a pixel differs from the one to the right or the one below by more than so many levels.</summary>
        public bool IsEdge(int x, int y, int levels) =>
            (x + 1 < picture.Width && PictureDifference.Levels(picture[x, y], picture[x + 1, y]) > levels)
            || (y + 1 < picture.Height && PictureDifference.Levels(picture[x, y], picture[x, y + 1]) > levels);
    }

    extension(Enum value)
    {
        /// <summary>The name in small letters, with blanks between its words.</summary>
        public string Words => JsonNamingPolicy.KebabCaseLower.ConvertName(value.ToString()).Replace('-', ' ');
    }

    extension(StringBuilder text)
    {
        /// <summary>Appends words in lines that a terminal shows whole.</summary>
        /// <param name="hang">How far all lines but the first are indented; as long as the head if left out.</param>
        public void Wrap(string head, string words, int? hang = null, int width = 96)
        {
            var (line, start) = (new StringBuilder(head), head.Length);
            foreach (var word in words.Split(' '))
            {
                if (line.Length + word.Length > width && line.Length > start)
                {
                    text.Append(line.ToString().TrimEnd()).Append('\n');
                    start = hang ?? head.Length;
                    line.Clear().Append(' ', start);
                }
                line.Append(word).Append(' ');
            }
            text.Append(line.ToString().TrimEnd()).Append('\n');
        }
    }
}
