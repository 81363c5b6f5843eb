using RayCaster.Teaching;

namespace Lab.Tests;

/// <summary>What the teacher sets.</summary>
public static class Teacher
{
    /// <summary>How much a failing picture test tells: Symptom (what is to be seen), Question (what to ask oneself) or Answer.</summary>
    public const HintLevel Hints = HintLevel.Question;

    /// <summary>How many random rays each test casts.</summary>
    public const int Rays = 1000;
}
