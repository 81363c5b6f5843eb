using System.Collections.Concurrent;

namespace RayCaster.Teaching.Comparison;

/// <summary>Which models of a scene have a colour in some light. Pictures have few colours, so each is looked up once.</summary>
internal sealed class ColorMap(Scene scene)
{
    /// <summary>What no model has in any light: neither a model's colour nor the background's.</summary>
    public const int Strange = -3;

    /// <summary>What several models have, or what is too dark to tell; the background's colour.</summary>
    private const int Several = -2, Background = -1;

    /// <summary>A darker pixel does not show a model's colour.</summary>
    private const int Dark = 24;

    private readonly ConcurrentDictionary<(byte R, byte G, byte B), (int Model, string? Kind)> known = [];

    /// <summary>The only model that has a colour; <see cref="Strange"/>, or another number below 0 for none or several.</summary>
    public int ModelOf((byte R, byte G, byte B) shown) => Find(shown).Model;

    /// <summary>The only kind of shape that has a colour; null if none or several have it.</summary>
    public string? KindOf((byte R, byte G, byte B) shown) => Find(shown).Kind;

    private (int Model, string? Kind) Find((byte R, byte G, byte B) shown) => known.GetOrAdd(shown, color =>
    {
        if (PictureJudge.IsNear(color, scene.Background.ToBytes())) return (Background, null);
        int[] models = [.. Enumerable.Range(0, scene.Models.Count).Where(model => Shade.IsOf(color, scene.Models[model].Color))];
        if (models.Length == 0) return (Strange, null);
        if (Math.Max(color.R, Math.Max(color.G, color.B)) < Dark) return (Several, null);
        return (models is [var only] ? only : Several,
            models.Select(model => scene.Models[model].Kind).Distinct().Take(2).ToArray() is [var kind] ? kind : null);
    });
}
