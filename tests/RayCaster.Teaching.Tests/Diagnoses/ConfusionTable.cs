using System.Globalization;
using System.Text;
using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>
/// How well the diagnosis names what <see cref="EditedLab"/> drew. A single mistake counts as named if the suspect is it alone, or has it for
/// a twin; a pair if one of both is in the first suspect. What changes fewer than
/// <see cref="SceneFitness.LeastPixels"/> pixels beyond rounding is not visible and not counted.
/// </summary>
internal sealed class ConfusionTable
{
    private readonly SortedDictionary<string, SortedDictionary<string, int>> confused = new(StringComparer.Ordinal);

    /// <summary>Visible single mistakes that were planted.</summary>
    public int Singles { get; private set; }

    /// <summary>Of these, those that the first suspect names.</summary>
    public int First { get; private set; }

    /// <summary>Of these, those that one of the first three suspects names.</summary>
    public int FirstThree { get; private set; }

    /// <summary>Pairs that were planted, each changing what either alone shows.</summary>
    public int Pairs { get; private set; }

    /// <summary>Pairs of which the first suspect has one.</summary>
    public int OneOfPair { get; private set; }

    /// <summary>Pairs of which the first suspect has both.</summary>
    public int BothOfPair { get; private set; }

    /// <summary>Pictures with one mistake that show nothing but background or black, so that none is named.</summary>
    public int Plain { get; private set; }

    /// <summary>Right pictures.</summary>
    public int Rights { get; private set; }

    /// <summary>Right pictures in which a mistake was named.</summary>
    public int FalseNames { get; private set; }

    /// <summary>Plants a mistake, if the scene shows it.</summary>
    public void Plant(Scene scene, Manner manner, Planted mistake)
    {
        if (manner.OtherSample && mistake == Planted.Named("center")) return; // cancels out
        var picture = EditedLab.Render(scene, manner, mistake, Planted.None);
        if (AreAlike(picture, EditedLab.Render(scene, manner, Planted.None, Planted.None))) return;
        var diagnosis = Diagnosis.Of(scene, picture);
        if (diagnosis.Finding == Finding.TellsNothing)
        {
            Plain++;
            return;
        }
        Singles++;
        var rank = diagnosis.Suspects.TakeWhile(suspect => !(suspect.Mistakes.Count == 1 && Has(suspect, mistake))).Count();
        if (rank < Math.Min(3, diagnosis.Suspects.Count)) FirstThree++;
        if (rank == 0 && diagnosis.Suspects.Count > 0) First++;
        else Confuse(mistake.Id, diagnosis);
    }

    /// <summary>Plants two mistakes, if each adds to the other.</summary>
    public void Plant(Scene scene, Manner manner, Planted one, Planted other)
    {
        var picture = EditedLab.Render(scene, manner, one, other);
        if (manner.OtherSample && (one == Planted.Named("center") || other == Planted.Named("center"))) return;
        if (AreAlike(picture, EditedLab.Render(scene, manner, one, Planted.None))) return;
        if (AreAlike(picture, EditedLab.Render(scene, manner, other, Planted.None))) return;
        if (AreAlike(picture, EditedLab.Render(scene, manner, Planted.None, Planted.None))) return;
        Pairs++;
        var diagnosis = Diagnosis.Of(scene, picture);
        var found = diagnosis.Suspects.Count == 0 ? 0 : (Has(diagnosis.Suspects[0], one) ? 1 : 0) + (Has(diagnosis.Suspects[0], other) ? 1 : 0);
        if (found > 0) OneOfPair++;
        if (found == 2) BothOfPair++;
        if (found == 0) Confuse($"{one.Id} + {other.Id}", diagnosis);
    }

    /// <summary>Draws without a mistake.</summary>
    public void Plant(Scene scene, Manner manner)
    {
        Rights++;
        var diagnosis = Diagnosis.Of(scene, EditedLab.Render(scene, manner, Planted.None, Planted.None));
        if (diagnosis.Finding == Finding.Matches) return;
        FalseNames++;
        Confuse($"right ({manner})", diagnosis);
    }

    /// <summary>A line for each mistake that was ever named wrongly: what was planted, and what was named how often.</summary>
    public string Confusions()
    {
        var text = new StringBuilder();
        foreach (var (planted, named) in confused)
            text.Append($"{planted,-28} named {string.Join(", ", named.Select(pair => $"{pair.Key} {pair.Value}"))}\n");
        return text.ToString();
    }

    /// <summary>The counts and shares, as the rows of a table.</summary>
    public string Summary()
    {
        var single = $"the first name is right (or its twin) in {Percent(First, Singles)}, " +
            $"one of the first three in {Percent(FirstThree, Singles)}";
        var pair = $"the first suspect has one of both in {Percent(OneOfPair, Pairs)}, both in {Percent(BothOfPair, Pairs)}";
        return string.Create(CultureInfo.InvariantCulture, $"""
            | planted | pictures | result |
            | --- | --: | --- |
            | one mistake, visible | {Singles} | {single} |
            | one mistake, nothing but background or black | {Plain} | no mistake is named, since very many draw that |
            | two mistakes, each visible beside the other | {Pairs} | {pair} |
            | none | {Rights} | a mistake is named in {FalseNames} |
            """).ReplaceLineEndings("\n");
    }

    /// <summary>A part of all; all of nothing.</summary>
    public static double Share(int count, int all) => all == 0 ? 1 : (double)count / all;

    private static string Percent(int count, int all) => string.Create(CultureInfo.InvariantCulture, $"{100 * Share(count, all):0.0} %");

    private static bool AreAlike(Picture a, Picture b) =>
        (a.Width, a.Height) == (b.Width, b.Height) && ChangedPixels.Count(a, b, levels: 2) < SceneFitness.LeastPixels;

    private static bool Has(Suspect suspect, Planted mistake) => suspect.Mistakes.Concat(suspect.Twins).Any(named => named.Id == mistake.Id);

    private void Confuse(string planted, Diagnosis diagnosis)
    {
        var named = diagnosis.Finding switch
        {
            Finding.Matches => "(right)",
            Finding.NoneOfThese => "(none of these)",
            Finding.TellsNothing => "(tells nothing)",
            Finding.Unfinished when diagnosis.Suspects.Count == 0 => "(unfinished)",
            _ => string.Join(" + ", diagnosis.Suspects[0].Mistakes.Select(mistake => mistake.Id)),
        };
        if (!confused.TryGetValue(planted, out var row)) confused[planted] = row = new(StringComparer.Ordinal);
        row[named] = row.GetValueOrDefault(named) + 1;
    }
}
