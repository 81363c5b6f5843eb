namespace RayCaster;

/// <summary>Why a crossing does not count.</summary>
public enum Refusal
{
    /// <summary>It counts.</summary>
    None,

    /// <summary>There is no crossing: t is NaN, or infinite for a ray parallel to the surface.</summary>
    NoNumber,

    /// <summary>t &lt; 0: behind the camera.</summary>
    Behind,

    /// <summary>0 ≤ t ≤ bias: too near to where the ray starts.</summary>
    UnderBias,

    /// <summary>z &lt; zNear.</summary>
    BeforeNear,

    /// <summary>z &gt; zFar.</summary>
    BeyondFar,
}
