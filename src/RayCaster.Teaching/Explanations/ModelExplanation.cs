namespace RayCaster.Teaching;

/// <summary>One model in the explanation of a pixel.</summary>
/// <param name="Name">Its name, or its path in the scene file.</param>
/// <param name="Steps">The steps of its formula; empty for a model in plain doubles and ifs, of which only t is known.</param>
/// <param name="Crossings">The crossings, nearest first; if there is none, one entry says why.</param>
public sealed record ModelExplanation(int Index, string Name, string Type, Outcome Outcome, string Reason,
    IReadOnlyList<FormulaStep> Steps, IReadOnlyList<CrossingExplanation> Crossings)
{
    /// <summary>A box's slabs; empty for other shapes.</summary>
    public IReadOnlyList<SlabExplanation> Slabs { get; init; } = [];

    /// <summary>A triangle's barycentric numbers w, u, v, which add up to 1; null for other shapes and for a triangle seen edge-on.</summary>
    public IReadOnlyList<double>? Weights { get; init; }

    /// <summary>The outcomes of a mesh's triangles; null for other shapes. Steps and crossings are those of
    /// <see cref="MeshExplanation.Triangle"/>.</summary>
    public MeshExplanation? Mesh { get; init; }

    /// <summary>Which neighbouring pixels show the model, in words; null if none does.</summary>
    public string? Beside { get; init; }
}

/// <summary>A slab of a box: the space lo ≤ coordinate ≤ hi.</summary>
/// <param name="Axis">x, y or z.</param>
/// <param name="T0">(lo − P) / d.</param>
/// <param name="T1">(hi − P) / d.</param>
/// <param name="Enters">The lesser of both.</param>
/// <param name="Leaves">The greater of both.</param>
/// <param name="DecidesEntry">Whether the ray enters this slab last, so t_min is its.</param>
/// <param name="DecidesExit">Whether the ray leaves this slab first, so t_max is its.</param>
public sealed record SlabExplanation(char Axis, double Lo, double Hi, double T0, double T1, double Enters, double Leaves,
    bool DecidesEntry, bool DecidesExit);

/// <summary>The outcomes of a mesh's triangles.</summary>
/// <param name="Triangle">The index of the explained triangle: the nearest that counts, else the nearest one that does not; null for none.</param>
/// <param name="UnderBias">How many are crossed at 0 ≤ t ≤ bias.</param>
/// <param name="Counting">How many crossings count; the nearest is the mesh's.</param>
public sealed record MeshExplanation(
    int Triangles, int? Triangle, int Missed, int Behind, int UnderBias, int BeforeNear, int BeyondFar, int Counting);

/// <summary>The outcomes of the models that are not explained one by one.</summary>
/// <param name="Count">How many there are in all.</param>
/// <param name="UnderBias">How many are crossed at 0 ≤ t ≤ bias only.</param>
public sealed record OtherModels(int Count, int Hidden, int Behind, int UnderBias, int BeforeNear, int BeyondFar, int Missed);
