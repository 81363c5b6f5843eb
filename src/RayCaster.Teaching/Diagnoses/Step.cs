namespace RayCaster.Teaching;

/// <summary>A step of the definition that a mistake may put another in the place of.</summary>
/// <typeparam name="F">What the step takes and gives.</typeparam>
/// <param name="definition">The right step.</param>
internal sealed class Step<F>(F definition) where F : Delegate
{
    /// <summary>The step as it is now.</summary>
    public F Do { get; private set; } = definition;

    /// <summary>Whether a mistake has changed it.</summary>
    public bool IsChanged { get; private set; }

    /// <summary>Puts another step around this one, or in its place, so that a second mistake adds to the first.</summary>
    /// <param name="other">Gets the step as it was; returns the step as it shall be.</param>
    public void Becomes(Func<F, F> other) => (Do, IsChanged) = (other(Do), true);
}
