namespace RayCaster.Teaching;

/// <summary>What may be wrong with a program: what it does not draw yet, and the mistakes that it makes besides, each in one wording.</summary>
/// <param name="Undone">What is not drawn yet.</param>
/// <param name="Wordings">The mistakes.</param>
internal sealed record Hypothesis(Undone Undone, IReadOnlyList<Mistake> Wordings)
{
    /// <summary>The program is right.</summary>
    public static readonly Hypothesis Right = new(Undone.Nothing, []);

    /// <summary>The same for all wordings of the same mistakes.</summary>
    public string Id => $"{(int)Undone} {string.Join(' ', Wordings.Select(wording => wording.Id).Order(StringComparer.Ordinal))}";

    /// <summary>The same with one more mistake.</summary>
    public Hypothesis With(Mistake wording) => this with { Wordings = [.. Wordings, wording] };

    /// <summary>The same without a mistake.</summary>
    public Hypothesis Without(Mistake wording) => new(Undone, [.. Wordings.Where(other => other != wording)]);

    /// <summary>Whether a mistake is in it, in whatever wording.</summary>
    public bool Has(string id) => Wordings.Any(wording => wording.Id == id);

    /// <summary>The program that this is true of, at work on a scene.</summary>
    public Lab Draw(Scene scene) => new(scene.Without(Undone), [.. Undone.Deviations(), .. Wordings]);
}
