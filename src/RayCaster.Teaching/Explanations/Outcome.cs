namespace RayCaster.Teaching;

/// <summary>What became of a ray and a model.</summary>
public enum Outcome
{
    /// <summary>The pixel shows the model.</summary>
    Shows,

    /// <summary>The model is hit, but a nearer one shows, or at the same t one that is earlier in the scene.</summary>
    Hidden,

    /// <summary>It is crossed at t &lt; 0: behind the camera.</summary>
    Behind,

    /// <summary>It is crossed at 0 ≤ t ≤ bias.</summary>
    UnderBias,

    /// <summary>It is crossed where z &lt; zNear.</summary>
    BeforeNear,

    /// <summary>It is crossed where z &gt; zFar.</summary>
    BeyondFar,

    /// <summary>A condition of its formula does not hold: outside of the circle, the triangle, a box's slabs.</summary>
    Outside,

    /// <summary>Its formula takes the root of a negative number: the ray passes by; also said of meshes, and of models without a formula.</summary>
    PassesBy,

    /// <summary>Its formula divides by 0: the ray runs along it.</summary>
    Along,

    /// <summary>Its formula gives no number (NaN) for another reason: its own numbers are out of range, or it is wrong.</summary>
    NoNumber,
}
