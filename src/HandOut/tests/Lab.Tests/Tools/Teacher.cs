using RayCaster.Teaching.Diagnosis;

namespace Lab.Tests;

/// <summary>What the teacher sets.</summary>
public static class Teacher
{
    /// <summary>What a failing picture test says: Symptom (what you see), Question (what to ask yourself) or Answer.</summary>
    public const HintLevel Hints = HintLevel.Question;

    /// <summary>How many random rays each test casts.</summary>
    public const int Rays = 1000;

    /// <summary>After so many seconds of processor time a test is taken for an endless loop, which stops the run. The slowest one needs a small part
    /// of it.</summary>
    public const int Seconds = 60;
}
