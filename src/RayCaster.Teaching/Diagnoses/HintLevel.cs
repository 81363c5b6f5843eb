namespace RayCaster.Teaching;

/// <summary>How much of a <see cref="Hint"/> is told; each level has those before it too.</summary>
public enum HintLevel
{
    /// <summary>Only what is to be seen.</summary>
    Symptom,

    /// <summary>What to ask oneself.</summary>
    Question,

    /// <summary>What is wrong, and what to write instead.</summary>
    Answer,
}
