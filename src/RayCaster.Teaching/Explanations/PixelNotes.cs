namespace RayCaster.Teaching.Explanations;

internal static class PixelNotes
{
    /// <summary>If two t agree this well, last bits of a formula decide which is less.</summary>
    private const double AlmostEqual = 1e-12;

    public static IReadOnlyList<string> Find(PixelExplanation pixel) =>
        [.. Shown(pixel), .. Ties(pixel), .. Faces(pixel), .. Light(pixel)];

    private static IEnumerable<string> Shown(PixelExplanation pixel)
    {
        // The explanation repeats the steps of ScalarRenderer, Ray.Intersect and Color, so a change there may make them differ.
        var drawn = new Picture(1, 1);
        ScalarRenderer.Render(pixel.Scene, drawn, pixel.Column, pixel.Line);
        if (drawn[0, 0] != pixel.Bytes)
            yield return $"ScalarRenderer draws {drawn[0, 0]} here: this build's course library was changed, and this does not explain how";
        if (pixel.Winner is null) yield return "no model is hit: the pixel shows the background, which is not attenuated";
        foreach (var neighbour in pixel.Neighbours)
            if (neighbour.Model != pixel.Winner)
                yield return $"an outline: the pixel {Where(neighbour)} shows {pixel.NameOf(neighbour.Model)}";
    }

    private static string Where(Neighbour neighbour) =>
        $"{(neighbour.Where is "left" or "right" ? $"to the {neighbour.Where}" : neighbour.Where)} (column {neighbour.Column}, " +
        $"line {neighbour.Line})";

    private static IEnumerable<string> Ties(PixelExplanation pixel)
    {
        var t = pixel.Hit.T;
        foreach (var result in pixel.Results)
        {
            if (result.Outcome != Outcome.Hidden) continue;
            if (result.T == t)
                yield return $"a tie: {pixel.NameOf(pixel.Winner)} and {pixel.NameOf(result.Index)} have the same t; the first in the scene shows";
            else if (result.T - t <= AlmostEqual * t)
                yield return $"almost a tie: t of {pixel.NameOf(pixel.Winner)} and of {pixel.NameOf(result.Index)} " +
                    "differ in the last digits only; another program may show either";
        }
    }

    private static IEnumerable<string> Faces(PixelExplanation pixel)
    {
        foreach (var model in pixel.Models)
            foreach (var slab in model.Slabs)
                if (slab.HoldsRay)
                    yield return $"{model.Name}: the ray runs in a face of the {slab.Axis} slab, " +
                        "where (B − P) / d is 0 / 0; the face belongs to the slab, so the ray is always in it";
    }

    private static IEnumerable<string> Light(PixelExplanation pixel)
    {
        var t = pixel.Hit.T;
        var fadeDistance = pixel.Scene.Camera.FadeDistance;
        if (pixel.Winner is not null && t >= fadeDistance)
            yield return $"all light is lost: {OutcomeReason.Compare("t", t, "≥", "2 |T − P|", fadeDistance)}, so the attenuation is 0";
        if (pixel.Color is { R: > 1 } or { G: > 1 } or { B: > 1 })
            yield return $"a channel is more than 1 and is clamped: the colour is {Digits.Format(pixel.Color)}";
    }
}
