namespace RayCaster.Teaching.Hypotheses;

/// <summary>The kind of difference that a wrong picture shows, if no mistake of the catalogue is certain.</summary>
internal static class LikelyCause
{
    /// <summary>A certain cause: one number of the scene is another, or one model is missing or has another colour.</summary>
    /// <returns>What it leaves unexplained, and a sentence; null for no cause.</returns>
    public static (Residual Residual, string? Sentence) Certain(SceneDiagnosis prepared, SceneDifference byModels, PictureSample sample)
    {
        if (ModelsText.Meant(byModels) is [{ IsExplained: true }])
            return (default, ModelsText.Sentences(prepared.Scene, byModels).FirstOrDefault());
        var (residual, sentence) = OtherNumber.Find(prepared.Scene, byModels, sample, prepared.Threads);
        return residual.Unexplained <= Decision.Explained * sample.WrongCount ? (residual, sentence) : default;
    }

    /// <summary>Other hints.</summary>
    public static IEnumerable<string> Hints(SceneDifference byModels, PictureSample sample)
    {
        var scene = sample.Scene;
        var certain = byModels.WrongKinds;
        var meant = ModelsText.Meant(byModels);
        var kinds = meant.Where(model => model.Model >= 0).Select(model => scene.Models[model.Model].Kind).Distinct().ToArray();
        if (InAnotherLight(sample, byModels.ModelAt).Count > 0 && (kinds.Length == 1 || !certain.IsCertain))
        {
            yield return meant is [{ } only] ? $"Only {only.Name}: the same outline, but another light. Is its t right?"
                : kinds is [var kind] && scene.Models.Any(model => model.Kind != kind)
                    ? $"Only {MissingParts.Many(kind)}: the same outlines, but another light. Is their t right?"
                : "All outlines are right, only the light is not: look at the attenuation, and at the way from a colour to its bytes.";
        }
        else if (certain.IsCertain || meant.Count == 1 || (meant.Count > 1 && meant.All(model => model.IsExplained)))
        {
            foreach (var sentence in ModelsText.Sentences(scene, byModels)) yield return sentence;
        }
    }

    /// <summary>What is wrong with the whole picture: its colours, its outlines, or their places; null if that is not known.</summary>
    public static string? OfTheWhole(PictureSample sample)
    {
        var scene = sample.Scene;
        var picture = sample.Picture;
        var background = scene.Background.ToBytes();
        var count = picture.Count;
        var strange = 0;
        var looked = Math.Min(4000, count);
        var places = new GoldenRatioSequence(count);
        for (var k = 0; k < looked; k++)
        {
            var shown = picture.At(places[k]);
            if (!PictureJudge.IsNear(shown, background)
                && !scene.Models.Any(model => Shade.IsOf(shown, model.Color))) strange++;
        }
        if (strange > looked / 2)
        {
            return string.Create(CultureInfo.InvariantCulture,
                $"This is another picture, or its colours were changed: {100.0 * strange / looked:0} % of its pixels have a colour " +
                $"that no model of the scene has in any light.");
        }
        if (sample.HasRightSize && IsWrongOnlyOnOutlines(picture, sample.Right))
            return "Only outlines are wrong: look at where in its pixel a ray passes. Was the picture scaled or smoothed on its way?";
        return strange > looked / 10 || sample.WrongCount < count / 3 ? null
            : "Its colours are those of the scene, but the outlines are others: look at the camera (P, T, up), at h and w, uc and ur, " +
                "and at which hit is the nearest.";
    }

    /// <summary>Whether most wrong pixels have a neighbour of another colour in the right picture.</summary>
    private static bool IsWrongOnlyOnOutlines(Picture picture, Picture right)
    {
        var wrong = 0;
        var outlines = 0;
        for (var y = 1; y < right.Height - 1; y++)
        {
            for (var x = 1; x < right.Width - 1; x++)
            {
                var here = right[x, y];
                if (PictureJudge.IsNear(picture[x, y], here)) continue;
                wrong++;
                if (IsOther(x - 1, y) || IsOther(x + 1, y) || IsOther(x, y - 1) || IsOther(x, y + 1)) outlines++;

                bool IsOther(int nx, int ny) => PictureDifference.Levels(right[nx, ny], here) > 8;
            }
        }
        return outlines > 0.5 * wrong;
    }

    /// <summary>
    /// In how many wrong pixels each kind of shape and the background shows, if nearly all of them show what they should in another light; empty
    /// if not.
    /// </summary>
    /// <param name="models">The model that each pixel should show, by its place in reading order; −1 for the background.</param>
    public static IReadOnlyDictionary<string, int> InAnotherLight(PictureSample sample, IReadOnlyList<int> models)
    {
        var scene = sample.Scene;
        var picture = sample.Picture;
        var right = sample.Right;
        var wrong = 0;
        var edges = 0;
        var count = new Dictionary<string, int>();
        var none = new Dictionary<string, int>();
        if (!sample.HasRightSize) return none;
        for (var i = 0; i < models.Count; i++)
        {
            var (y, x) = Math.DivRem(i, right.Width);
            var shown = picture[x, y];
            if (PictureJudge.IsNear(shown, right[x, y])) continue;
            wrong++;
            var (kind, color) = models[i] < 0 ? ("background", scene.Background) : (scene.Models[models[i]].Kind, scene.Models[models[i]].Color);
            if (Shade.IsOf(shown, color) || Shade.IsTooBright(shown, color)) count[kind] = count.GetValueOrDefault(kind) + 1;
            // Two grey models are shades of each other, and black is a shade of all. Then a new edge within a model shows the difference.
            if ((x > 0 && IsNewEdge(x - 1, y)) || (y > 0 && IsNewEdge(x, y - 1))) edges++;

            bool IsNewEdge(int nx, int ny) => models[ny * right.Width + nx] == models[i] &&
                PictureDifference.Levels(right[x, y], right[nx, ny]) <= 8 && PictureDifference.Levels(shown, picture[nx, ny]) > 40;
        }
        // A cut through an area is about as long as its side.
        return count.Values.Sum() >= 0.97 * wrong && 4 * edges <= Math.Sqrt(wrong) ? count : none;
    }
}
