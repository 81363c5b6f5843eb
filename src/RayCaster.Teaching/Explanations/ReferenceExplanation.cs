using static RayCaster.Teaching.Comparison.PictureJudge;

namespace RayCaster.Teaching.Explanations;

/// <summary>Compares an explained pixel with another picture, and finds what would give the other picture's colour.</summary>
/// <param name="Bytes">The other picture's bytes.</param>
/// <param name="Difference">The other picture's bytes minus the pixel's.</param>
/// <param name="Agrees">Whether each channel differs by at most 1, as by rounding.</param>
/// <param name="Causes">If they do not agree: sentences that say what in the scene would give the other colour.</param>
public sealed record ReferenceExplanation(
    (byte R, byte G, byte B) Bytes, (int R, int G, int B) Difference, bool Agrees, IReadOnlyList<string> Causes)
{
    private const int MaxCauses = 6;

    /// <summary>Compares a pixel with another picture.</summary>
    /// <param name="reference">The other picture, of the same size.</param>
    public static ReferenceExplanation Create(PixelExplanation pixel, Picture reference)
    {
        var mine = pixel.Bytes;
        var other = reference[pixel.Column, pixel.Line];
        var agrees = IsNear(mine, other);
        return new(other, (other.R - mine.R, other.G - mine.G, other.B - mine.B), agrees,
            agrees ? [] : [.. FindCauses(pixel, other).Take(MaxCauses).Select(cause => "the other picture's colour is " + cause)]);
    }

    private static IEnumerable<string> FindCauses(PixelExplanation pixel, (byte R, byte G, byte B) other)
    {
        var scene = pixel.Scene;
        if (pixel.Winner is not null && IsNear(scene.Background.ToBytes(), other)) yield return "the background's: there the ray hits nothing";

        foreach (var result in pixel.Results)
        {
            var model = new ModelExplanation(pixel, result);
            foreach (var crossing in model.Crossings)
            {
                var t = crossing.Untested ?? crossing.T;
                if (crossing.Outcome is Outcome.Shows || !double.IsFinite(t)) continue;
                if (!IsNear(scene.Shade(new(t, result.Index)).ToBytes(), other)) continue;
                yield return $"what {model.Name} would give: its crossing at t = {Digits.Format(t)} {ResultOf(crossing)}";
            }
            if (IsNear(result.Model.Color.ToBytes(), other)) yield return $"that of {model.Name}, not attenuated";
        }
        foreach (var neighbour in pixel.Neighbours)
            if (neighbour.Model != pixel.Winner && neighbour.Model is { } shown
                && IsNear(scene.Shade(new(neighbour.T, shown)).ToBytes(), other))
                yield return $"that of the pixel {neighbour.Where} of this one, which shows {pixel.NameOf(shown)}";
    }

    private static string ResultOf(CrossingExplanation crossing) => crossing.Outcome switch
    {
        Outcome.NotNeeded => "is not needed, for the one before it counts",
        Outcome.Hidden => $"is {crossing.Reason}",
        Outcome.Misses => $"is none, for {crossing.Reason}",
        _ => $"does not count, for {crossing.Reason}",
    };
}
