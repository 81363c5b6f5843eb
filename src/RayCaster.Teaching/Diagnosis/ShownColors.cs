namespace RayCaster.Teaching.Diagnosis;

/// <summary>Which kinds of shape a picture shows by their colours: what it shows, at any place, is drawn.</summary>
internal static class ShownColors
{
    /// <summary>
    /// The ways in which only such kinds are missing whose colours the picture does not show: a colour shows what is drawn, at any place. The ways
    /// without the most kinds come first. Clipping may be the only missing part.
    /// </summary>
    /// <param name="pictures">The pictures of one program.</param>
    public static IEnumerable<IReadOnlyList<string>> MissingParts(IReadOnlyList<PictureSample> pictures, IReadOnlyCollection<string> done)
    {
        var kinds = KindsOf(pictures);
        var expected = new int[kinds.Length];
        var seen = new int[kinds.Length];
        foreach (var picture in pictures)
        {
            CountKinds(picture.Colors, picture.Right, kinds, expected);
            CountKinds(picture.Colors, picture.Picture, kinds, seen);
        }
        string[] unseen = [.. kinds.Where((kind, i) => seen[i] <= expected[i] / 500 && !done.Contains(kind))];
        return from missing in Subsets(unseen).Reverse()
               where missing.Length < kinds.Length
               from rest in Rest(done)
               where missing.Length > 0 || rest.Contains(MissingPart.Clipping)
               select (IReadOnlyList<string>)[.. missing, .. rest];
    }

    public static string[] KindsOf(IReadOnlyList<PictureSample> pictures) =>
        [.. pictures.SelectMany(picture => picture.Scene.Models).Select(model => model.Kind).Distinct()];

    private static IEnumerable<string[]> Rest(IReadOnlyCollection<string> done) =>
        Subsets([.. ((string[])[MissingPart.Attenuation, MissingPart.Clipping]).Except(done)]);

    private static IEnumerable<string[]> Subsets(string[] all) =>
        Enumerable.Range(0, 1 << all.Length).Select(bits => all.Where((_, i) => (bits >> i & 1) != 0).ToArray());

    /// <summary>Counts, in some thousand pixels, how many show a colour that only one kind has.</summary>
    private static void CountKinds(ColorMap colors, Picture picture, string[] kinds, int[] seen)
    {
        var places = new GoldenRatioSequence(picture.Count);
        for (var k = 0; k < Math.Min(8000, picture.Count); k++)
            if (colors.KindOf(picture.At(places[k])) is { } only) seen[Array.IndexOf(kinds, only)]++;
    }
}
