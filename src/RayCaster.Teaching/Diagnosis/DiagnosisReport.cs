using System.Buffers;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayCaster.Teaching.Diagnosis;

/// <summary>A <see cref="DiagnosisResult"/> in words for students, and as JSON for other programs.</summary>
public static class DiagnosisReport
{
    private static readonly JsonWriterOptions options = new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping, // letters of all languages stay
    };

    /// <summary>Lines of text.</summary>
    public static string Text(DiagnosisResult diagnosis, string picture, string scene, HintLevel level = HintLevel.Question)
    {
        var text = new StringBuilder();
        if (diagnosis.Kind == DiagnosisKind.Matches)
        {
            AppendMatch(text, diagnosis, picture, scene);
            return text.ToString();
        }
        if (diagnosis.CroppedPart is { } missingPart)
        {
            text.Wrap("", $"{picture} is the picture of {scene} without {missingPart}. {ComparisonText.Cropped}");
            return text.ToString();
        }
        text.AppendLine($"{picture} is not the picture of {scene}: {Digits.Part(diagnosis.WrongCount, diagnosis.PixelCount)} " +
            $"differ by more than {PictureJudge.Tolerance} level.");
        text.AppendLine();
        if (diagnosis.MissingParts.Count > 0)
            text.Wrap("", $"Not drawn yet: {string.Join(", ", diagnosis.MissingParts)}.{(!IsRestRight(diagnosis) ? ""
                : diagnosis.MissingParts.Any(MissingPart.IsShape) ? " All other pixels are right." : " The rest is right.")}");
        AppendLost(text, diagnosis);
        foreach (var likely in diagnosis.Likely) text.Wrap("", likely);
        if (diagnosis.Kind == DiagnosisKind.TellsNothing)
            text.Wrap("", "Very many mistakes make such a picture, so none is named. \"explain\" shows how each pixel should get its colour.");
        else if (diagnosis.Kind == DiagnosisKind.NoneOfThese) AppendNone(text, diagnosis, picture, scene, level);
        else if (diagnosis.Kind == DiagnosisKind.Mistake) AppendSuspects(text, diagnosis, level);
        return text.ToString();
    }

    private static bool IsRestRight(DiagnosisResult diagnosis) =>
        diagnosis.Kind == DiagnosisKind.Unfinished || diagnosis.Suspects is [{ Unexplained: < 0.5 } first, ..] && IsOnlyUnwritten(first);

    /// <summary>Whether a program without attenuation or clipping, but with no other mistake, draws the same.</summary>
    private static bool IsOnlyUnwritten(Suspect suspect) => !Beside(suspect).Any();

    /// <summary>The mistakes that are not a part that is not written yet.</summary>
    private static IEnumerable<Change> Beside(Suspect suspect) => suspect.Mistakes.Except(MissingPart.AsMistakes(suspect.MissingParts));

    private static void AppendMatch(StringBuilder text, DiagnosisResult diagnosis, string picture, string scene)
    {
        if (diagnosis.ProvesNothing)
            text.AppendLine($"The picture of {scene} is of one colour, as that of an empty world: it proves nothing.");
        var outlines = diagnosis.WrongCount + diagnosis.OutlineCount;
        text.AppendLine($"{picture} matches: it is the picture of {scene}" +
            $"{(outlines > 0 ? $", but for {Digits.Count(outlines, "pixel")} on outlines" : "")}.");
        if (diagnosis.Rounding is { } rounding) text.Append($"It {rounding}");
    }

    /// <summary>After "matches": the mistakes that the scene cannot show, because a right picture does not prove a right program.</summary>
    public static string HiddenText(Diagnoser prepared)
    {
        var hidden = prepared.Hidden;
        if (hidden.Count == 0) return "";
        var text = new StringBuilder();
        var tried = prepared.TriedForHidden;
        text.Wrap("",
            $"This scene cannot show {hidden.Count} of the " + (tried == MistakeCatalog.Visible.Count
                ? $"{MistakeCatalog.All.Count} known mistakes: " : $"{tried} known mistakes that were tried (of {MistakeCatalog.All.Count}): ") +
            $"{string.Join(", ", hidden.Select(mistake => mistake.Id))}. \"check\" says why.");
        return text.ToString();
    }

    private static void AppendNone(StringBuilder text, DiagnosisResult diagnosis, string picture, string scene, HintLevel level)
    {
        if (diagnosis.TooManyModels)
        {
            text.AppendLine(string.Create(CultureInfo.InvariantCulture,
                $"The known mistakes were not tried: the scene has more than {MutationCoverage.MaxModels:N0} models. Make a smaller one."));
            return;
        }
        text.Wrap("", "None of the known mistakes makes this picture." + (diagnosis.IsOfScene ? ""
            : diagnosis.Likely.Count > 0 ? " Is it of this scene?"
            : " Is it of this scene, with this camera, and as your program wrote it, not scaled, cropped or compressed on its way?"));
        text.Wrap("", $"\"draw {scene} -o right.png\" draws the right picture; then \"compare {picture} right.png --scene {scene}\" says which " +
            "models are wrong, and whether the whole is moved or has other colours. \"explain\" shows how each pixel should get its colour.");
        if (diagnosis.Nearest.Count > 0) text.AppendLine("The nearest mistakes, though none explains the picture:");
        foreach (var nearest in diagnosis.Nearest)
        {
            var question = level >= HintLevel.Question && nearest.Mistakes is [var only] ? $" {only.Hint.Question}" : "";
            text.Wrap("  ", $"{Names(nearest)} would leave {Rest(diagnosis, nearest)}.{question}", 4);
        }
    }

    /// <summary>Which mistakes lose a shape that is written already.</summary>
    private static void AppendLost(StringBuilder text, DiagnosisResult diagnosis)
    {
        if (diagnosis.Kind == DiagnosisKind.Unfinished && diagnosis.Suspects.Count > 0)
            text.Wrap("", $"If that is written already, a slip in it, or in what it uses, hides it; so do the mistakes " +
                $"{string.Join(", ", diagnosis.Suspects.Select(Names))}.");
        else if (diagnosis.MissingParts.FirstOrDefault(MissingPart.IsShape) is { } shape)
            text.Wrap("", $"If one of these is written already, name it: \"diagnose --done {shape}\" says which mistakes hide it.");
    }

    private static void AppendSuspects(StringBuilder text, DiagnosisResult diagnosis, HintLevel level)
    {
        var suspects = diagnosis.Suspects;
        AppendSuspect(text, diagnosis, suspects[0], level);
        if (suspects.Count > 1 && level == HintLevel.Answer)
        {
            text.AppendLine();
            text.AppendLine("Less likely:");
            foreach (var suspect in suspects.Skip(1))
            {
                var rest = suspect.SamePicture ? "draws the same picture" : $"would leave {Rest(diagnosis, suspect)}";
                text.AppendLine($"  {Names(suspect),-16} {rest}");
            }
        }
    }

    /// <summary>Everything, with the answers.</summary>
    /// <param name="picture">The picture's size.</param>
    /// <param name="scene">The size that the scene's picture should have.</param>
    /// <param name="hidden">The mistakes that the scene cannot show.</param>
    /// <param name="warning">Why all of it may be wrong; left out if null.</param>
    public static string Json(
        DiagnosisResult diagnosis, (int Width, int Height) picture, (int Width, int Height) scene, IReadOnlyList<Mistake> hidden, string? warning)
    {
        var suspects = diagnosis.Suspects
            .Select((suspect, i) => Json(suspect, i == 0 ? "likely" : suspect.AsLikely ? "as likely" : "less likely"))
            .Concat(diagnosis.Nearest.Select(nearest => Json(nearest, "nearest, explains too little")));
        return TextOf(new()
        {
            ["warning"] = warning,
            ["finding"] = diagnosis.Kind.Words,
            ["mine"] = Json(picture),
            ["scene"] = Json(scene),
            ["pixels"] = diagnosis.PixelCount,
            ["wrong"] = diagnosis.WrongCount,
            ["rounding"] = diagnosis.Rounding,
            ["missing"] = diagnosis.MissingModel ?? diagnosis.CroppedPart,
            ["notYet"] = Json(diagnosis.MissingParts),
            ["likely"] = Json(diagnosis.Likely),
            ["cannotShow"] = Json(hidden.Select(mistake => mistake.Id)),
            ["suspects"] = new JsonArray([.. suspects]),
        });
    }

    /// <summary>The same object if nothing could be diagnosed, with the reason.</summary>
    public static string Json(string error) => TextOf(new() { ["finding"] = "could not tell", ["error"] = error });

    private static JsonObject Json((int Width, int Height) size) => new() { ["width"] = size.Width, ["height"] = size.Height };

    private static JsonArray Json(IEnumerable<string> texts) => new([.. texts.Select(text => (JsonNode)text)]);

    private static JsonObject Json(Suspect suspect, string rank) => new()
    {
        ["rank"] = rank,
        ["mistakes"] = new JsonArray([.. suspect.Mistakes.Select(mistake => Json(mistake, suspect.HasSymptoms))]),
        ["unexplained"] = Math.Round(suspect.Unexplained),
        ["otherSample"] = suspect.OtherSample,
        ["samePicture"] = suspect.SamePicture,
        ["twins"] = Json(suspect.Twins.Select(twin => twin.Id)),
        ["notYet"] = Json(suspect.MissingParts),
    };

    private static JsonObject Json(Change mistake, bool hasSymptom) => WithoutNulls(new()
    {
        ["id"] = mistake.Id,
        ["cause"] = mistake.Cause,
        ["similarTo"] = mistake.Similar?.Id,
        ["symptom"] = hasSymptom && mistake.Hint.Symptom != "" ? mistake.Hint.Symptom : null,
        ["question"] = mistake.Hint.Question,
        ["answer"] = mistake.Hint.Answer,
        ["slide"] = mistake.Slide,
        ["step"] = mistake.Place?.Step,
        ["name"] = mistake.Place?.Name,
        ["formula"] = mistake.Place?.Formula,
    });

    private static JsonObject WithoutNulls(JsonObject o)
    {
        foreach (var (name, _) in o.Where(property => property.Value is null).ToArray()) o.Remove(name);
        return o;
    }

    private static string TextOf(JsonObject o)
    {
        var text = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(text, options)) WithoutNulls(o).WriteTo(json);
        return Encoding.UTF8.GetString(text.WrittenSpan) + "\n";
    }

    private static void AppendSuspect(StringBuilder text, DiagnosisResult diagnosis, Suspect suspect, HintLevel level)
    {
        var shown = Shown(suspect);
        text.AppendLine((IsOnlyUnwritten(suspect) ? "If that is written already, most likely:"
                : suspect.OtherFormulas.Count > 0 ? "Most likely one of these:" : "Most likely:")
            + (level == HintLevel.Answer ? " " + Names(suspect) // an id says what is wrong
                : shown is [{ Place: not null } slip] ? " " + NameOf(slip with { Similar = null })
                : shown.Count > 1 ? $" {shown.Count} mistakes" : "")
            + (shown.Count switch { 1 => "", 2 => ", both at once", _ => ", all at once" }));
        foreach (var mistake in shown)
        {
            if (shown.Count > 1 && level == HintLevel.Answer) text.AppendLine($"  {NameOf(mistake)}");
            if (suspect.HasSymptoms && mistake.Hint.Symptom != "") text.Wrap("  Symptom:  ", mistake.Hint.Symptom);
            if (level >= HintLevel.Question) text.Wrap("  Question: ", mistake.Hint.Question);
            if (level < HintLevel.Answer) continue;
            text.Wrap("  Cause:    ", mistake.Cause);
            text.Wrap("  Answer:   ", mistake.Hint.Answer);
            text.Wrap("  Slide:    ", mistake.Slide);
        }
        text.AppendLine($"  {Explains(diagnosis, suspect)}.");
        if (suspect.OtherSample)
            text.Wrap("  Besides:  ", "the rays pass through another point of each pixel than the scene's \"sample\" says (corner or center).");
        if (suspect.OtherFormulas.Count > 0)
        {
            var steps = suspect.Mistakes.SelectMany(mistake => mistake.OwnSteps).Select(step => step.InWords()).Distinct();
            text.Wrap("  Or:       ", $"a slip in the step {string.Join(", ", steps)} draws the same here: " +
                $"in {string.Join(", or in ", suspect.OtherFormulas)}.");
        }
        if (suspect.Twins.Count > 0)
            text.Wrap("  Twins:    ",
                (level == HintLevel.Answer ? $"on this scene {string.Join(", ", suspect.Twins.Select(twin => twin.Id))}"
                    : suspect.Twins.Count == 1 ? "on this scene another mistake" : $"on this scene {suspect.Twins.Count} other mistakes")
                + $" {(suspect.Twins.Count == 1 ? "gives" : "give")} the same picture; \"check\" shows which scene would distinguish them.");
    }

    private static string Names(Suspect suspect) => string.Join(" + ", Shown(suspect).Select(NameOf));

    /// <summary>An id; a slip that has none in words.</summary>
    private static string NameOf(Change mistake) => (mistake.Place is { } place ? $"a slip in the step \"{place.Step}\"" : mistake.Id)
        + (mistake.Similar is { } similar ? $" (similar to {similar.Id})" : "");

    private static IReadOnlyList<Change> Shown(Suspect suspect) => IsOnlyUnwritten(suspect) ? suspect.Mistakes : [.. Beside(suspect)];

    private static string Rest(DiagnosisResult diagnosis, Suspect suspect) => suspect.Unexplained < 0.5
        ? "nothing unexplained"
        : $"{Share(suspect.Unexplained, diagnosis)} of the pixels unexplained";

    private static string Explains(DiagnosisResult diagnosis, Suspect suspect) => suspect.Unexplained < 0.5
        ? "This explains every wrong pixel"
        : $"This explains all but {Share(suspect.Unexplained, diagnosis)} of the pixels";

    private static string Share(double pixels, DiagnosisResult diagnosis) => Digits.Share((int)Math.Round(pixels), diagnosis.PixelCount);
}
