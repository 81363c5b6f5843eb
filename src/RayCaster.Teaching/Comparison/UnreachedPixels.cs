namespace RayCaster.Teaching.Comparison;

/// <summary>Whole lines, columns or blocks that have one colour and should not: no loop reached them.</summary>
internal sealed class UnreachedPixels
{
    /// <summary>By how many levels neighbours may differ on one model, and by how many they must at the end of an area.</summary>
    private const int Smooth = 8, Jump = 4;

    /// <summary>How many colours are tried, the most frequent of the wrong pixels first.</summary>
    private const int Colors = 3;

    /// <summary>The most threads that may share the lines.</summary>
    private const int MostThreads = 64;

    /// <summary>The sides of the blocks that threads draw.</summary>
    private static readonly int[] sides = [128, 64, 32, 16, 8, 4];

    private readonly bool[] isUnreached;

    private UnreachedPixels(string sentence, bool isRestRight, bool[] isUnreached, Picture rest) =>
        (Sentence, IsRestRight, this.isUnreached, Rest) = (sentence, isRestRight, isUnreached, rest);

    /// <summary>Which pixels they are and which colour they have, and a question.</summary>
    public string Sentence { get; }

    /// <summary>Whether the picture is right but for them.</summary>
    public bool IsRestRight { get; }

    /// <summary>The picture, in which these pixels show what they should.</summary>
    public Picture Rest { get; }

    /// <summary>Whether a pixel is one of them, by its index in reading order.</summary>
    public bool Contains(int pixel) => isUnreached[pixel];

    /// <summary>Finds them in a picture that has the right one's size; null if there are none.</summary>
    /// <param name="scene">The picture's scene; null if it is not known.</param>
    public static UnreachedPixels? Find(PictureDifference difference, Scene? scene)
    {
        if (difference.Mine.IsNearlyOneColor) return null;
        int[] wrong = [.. Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong)];
        return wrong.CountBy(difference.Mine.At).OrderByDescending(color => color.Value).Take(Colors)
            .Select(color => new Finder(difference, wrong, color.Key).Find(scene)).FirstOrDefault(found => found is not null);
    }

    /// <summary>Looks for areas of one colour.</summary>
    private sealed class Finder(PictureDifference difference, int[] wrong, (byte R, byte G, byte B) color)
    {
        private readonly int width = difference.Mine.Width, height = difference.Mine.Height;
        private readonly bool[] isWrong = Marked(difference, wrong, color); // and of the colour
        private readonly bool[] isFound = new bool[difference.Pixels];
        private readonly bool isOfMemory = color.R == color.G && color.G == color.B; // new memory has one value in all bytes

        public UnreachedPixels? Find(Scene? scene)
        {
            int[] lines = Whole(height, width, InLine), columns = Whole(width, height, InColumn);
            if (IsPlainElsewhere(lines, height, width, InLine) || IsPlainElsewhere(columns, width, height, InColumn)) return null;
            HashSet<int> wholeLines = [.. lines], wholeColumns = [.. columns];
            foreach (var i in Enumerable.Range(0, difference.Pixels)) isFound[i] = isWrong[i] && IsInWhole(i);
            var blocks = Blocks();
            var found = isFound.Count(pixel => pixel);
            var left = isWrong.Count(pixel => pixel) - found;
            if (found == 0 || 4 * left > found || !CutsThroughModels()) return null;
            var (mine, right) = (difference.Mine, difference.Reference);
            var rest = Picture.Create(width, height, (x, y) => isFound[y * width + x] ? right[x, y] : mine[x, y]);
            var isRestRight = new PictureJudge(right, scene).Judge(rest) != Likeness.Wrong;
            // Where much else is wrong, an area of the background is that of another camera, or of a shape that is not drawn.
            var isBackground = scene is not null && PictureJudge.IsNear(color, scene.Background.ToBytes());
            if (!isRestRight && isBackground && lines.Length + columns.Length > 4 && !IsPeriodic(lines) && blocks is null) return null;
            // By chance some of them are right: another mistake would draw these otherwise.
            bool[] unreached = [.. isFound.Select((isOne, i) => isOne || (Has(i) && IsInWhole(i)))];
            return new(Sentence(lines, columns, blocks), isRestRight, unreached, rest);

            int InLine(int along, int across) => across * width + along;

            int InColumn(int along, int across) => along * width + across;

            bool IsInWhole(int pixel) => wholeLines.Contains(pixel / width) || wholeColumns.Contains(pixel % width);
        }

        /// <summary>The lines, or the columns, that have the colour from one end to the other and should not.</summary>
        private int[] Whole(int count, int length, Func<int, int, int> place) =>
        [
            .. Enumerable.Range(0, count).Where(across => Enumerable.Range(0, length).All(along => Has(place(along, across)))
                && Enumerable.Range(0, length).Any(along => isWrong[place(along, across)])),
        ];

        /// <summary>Whether more lines, or columns, have another colour each, and should not: then all rays of one are the same ray.</summary>
        private bool IsPlainElsewhere(int[] found, int count, int length, Func<int, int, int> place) =>
            found.Length > 0 && Enumerable.Range(0, count).Except(found).Count(across =>
            {
                var first = difference.Mine.At(place(0, across));
                return Enumerable.Range(0, length).All(along => difference.Mine.At(place(along, across)) == first)
                    && Enumerable.Range(0, length).Any(along => difference.IsWrong(place(along, across)));
            }) > found.Length;

        /// <summary>Takes the blocks of a grid in, or rectangles, if they hold all other pixels of the colour; their words, or null.</summary>
        private string? Blocks()
        {
            int[] others = [.. Enumerable.Range(0, difference.Pixels).Where(i => isWrong[i] && !isFound[i])];
            if (others.Length < 12) return null;
            foreach (var side in sides)
            {
                if (side >= width && side >= height) continue;
                foreach (var start in ((int[])[0, height % side]).Distinct()) // lines are counted from the top, or from the bottom
                {
                    var first = start == 0 ? 0 : start - side;
                    var blocks = others.Select(i => (X: i % width / side, Y: (i / width - first) / side)).Distinct().ToArray();
                    if (!blocks.All(block => IsFull(block.X * side, first + block.Y * side, side, side))) continue;
                    if (blocks.Length == 1 && !isOfMemory) continue;
                    foreach (var i in others) isFound[i] = true;
                    return blocks.Length == 1 ? Rectangle(others)
                        : $"{Digits.Count(blocks.Length, "block")} of {side} x {side} pixels are";
                }
            }
            var (left, right) = (others.Min(i => i % width), others.Max(i => i % width));
            var (top, bottom) = (others.Min(i => i / width), others.Max(i => i / width));
            if (!isOfMemory || right - left < 3 || bottom - top < 3 || !IsFull(left, top, right - left + 1, bottom - top + 1)) return null;
            foreach (var i in others) isFound[i] = true;
            return Rectangle(others);
        }

        private string Rectangle(int[] pixels) =>
            $"The columns {pixels.Min(i => i % width)} to {pixels.Max(i => i % width)} of the lines {pixels.Min(i => i / width)} to " +
            $"{pixels.Max(i => i / width)} from the top are";

        private bool IsFull(int left, int top, int across, int down)
        {
            for (var y = Math.Max(0, top); y < Math.Min(height, top + down); y++)
                for (var x = left; x < Math.Min(width, left + across); x++)
                    if (!Has(y * width + x)) return false;
            return true;
        }

        /// <summary>Whether many of the ends lie where the right picture shows one model, and are sharp. Those that a lost shape or a fading light
        /// leaves do not.</summary>
        private bool CutsThroughModels()
        {
            var (cuts, ends) = (0, 0);
            for (var i = 0; i < isFound.Length; i++)
            {
                if (!isFound[i]) continue;
                var (y, x) = Math.DivRem(i, width);
                if (x > 0) Look(i - 1);
                if (x + 1 < width) Look(i + 1);
                if (y > 0) Look(i - width);
                if (y + 1 < height) Look(i + width);

                void Look(int other)
                {
                    if (isFound[other]) return;
                    ends++;
                    if (PictureDifference.Levels(difference.Reference.At(i), difference.Reference.At(other)) <= Smooth
                        && PictureDifference.Levels(color, difference.Mine.At(other)) > Jump) cuts++;
                }
            }
            return 4 * cuts > ends;
        }

        private bool Has(int pixel) => difference.Mine.At(pixel) == color;

        private string Sentence(int[] lines, int[] columns, string? blocks)
        {
            string[] parts = [.. ((string?[])[Words(lines, height, "line"), Words(columns, width, "column")]).OfType<string>()];
            if (parts.Length == 0)
                return $"{blocks} {color}: does your loop reach them, and which thread draws them?";
            var all = string.Join(" and ", parts);
            var isOne = lines.Length + columns.Length == 1 || (parts.Length == 1 && IsPeriodic(lines.Length > 0 ? lines : columns));
            var also = blocks is null ? "" : $" {blocks}, too.";
            var threads = columns.Length == 0 && lines.Length > 1 && lines[^1] - lines[0] == lines.Length - 1
                && (lines[0] == 0 || lines[^1] == height - 1) ? ByThreads(lines.Length) : "";
            return $"{char.ToUpperInvariant(all[0])}{all[1..]} {(isOne ? "is" : "are")} {color}: " +
                $"does your loop reach {(lines.Length + columns.Length == 1 ? "it" : "them")}?{also}{threads}";
        }

        /// <summary>Whether threads that draw equally many lines each leave so many.</summary>
        private string ByThreads(int lines)
        {
            var threads = Enumerable.Range(2, MostThreads - 1).FirstOrDefault(count => height % count == lines);
            return threads == 0 ? "" : $" If threads share the lines: {height} divided by {threads} leaves {lines}. Who draws the rest?";
        }

        /// <summary>Some lines or columns in words; null if there are none.</summary>
        private static string? Words(int[] some, int count, string what)
        {
            if (some.Length == 0) return null;
            if (some.Length == 1)
                return some[0] == 0 ? $"the first {what}" : some[0] == count - 1 ? $"the last {what}" : $"the {what} {some[0]}{From(what)}";
            if (some[^1] - some[0] == some.Length - 1)
                return some[0] == 0 ? $"the first {some.Length} {what}s" : some[^1] == count - 1 ? $"the last {some.Length} {what}s"
                    : $"the {what}s {some[0]} to {some[^1]}{From(what)}";
            if (IsPeriodic(some))
                return some[1] - some[0] == 2 ? $"every second {what}, from {what} {some[0]} on,"
                    : $"every {some[1] - some[0]}th {what}, from {what} {some[0]} on,";
            if (some is [0, 1] || some.Length == 2 && some[0] == 0 && some[1] == count - 1) return $"the first and the last {what}";
            var first = some.TakeWhile((at, i) => at == i).Count();
            var last = some.Reverse().TakeWhile((at, i) => at == count - 1 - i).Count();
            if (first > 0 && first + last == some.Length) return $"the first {first} and the last {last} {what}s";
            return $"{some.Length} {what}s, {string.Join(", ", Runs(some).Take(4))}{(Runs(some).Skip(4).Any() ? " …" : "")}{From(what)}";
        }

        private static string From(string what) => what == "line" ? " from the top" : "";

        private static IEnumerable<string> Runs(int[] some)
        {
            for (var i = 0; i < some.Length; i++)
            {
                var first = some[i];
                while (i + 1 < some.Length && some[i + 1] == some[i] + 1) i++;
                yield return first == some[i] ? $"{first}" : $"{first} to {some[i]}";
            }
        }

        private static bool IsPeriodic(int[] some) =>
            some.Length > 2 && some[1] - some[0] > 1 && some.Zip(some.Skip(1)).All(pair => pair.Second - pair.First == some[1] - some[0]);

        private static bool[] Marked(PictureDifference difference, int[] wrong, (byte, byte, byte) color)
        {
            var marked = new bool[difference.Pixels];
            foreach (var i in wrong) marked[i] = difference.Mine.At(i) == color;
            return marked;
        }
    }
}
