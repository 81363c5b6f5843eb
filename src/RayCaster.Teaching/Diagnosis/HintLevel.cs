namespace RayCaster.Teaching.Diagnosis;

/// <summary>How much of a <see cref="Hint"/> is shown; each level includes those before it.</summary>
public enum HintLevel
{
    /// <summary>Only what one sees.</summary>
    Symptom,

    /// <summary>What to ask oneself.</summary>
    Question,

    /// <summary>What is wrong, and what to write instead.</summary>
    Answer,
}
