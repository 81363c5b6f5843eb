namespace RayCaster.Teaching;

/// <summary>A step of the definition that mistakes change: one puts another formula in its place, others lay themselves around it.</summary>
/// <remarks>What is around a formula stays around it, in whichever order the mistakes are made, so that a second mistake adds to the
/// first.</remarks>
/// <typeparam name="F">What the step takes and gives.</typeparam>
internal sealed class Step<F>(F definition) where F : Delegate
{
    private readonly List<Func<F, F>> around = [];

    public F Do { get; private set; } = definition;

    public bool IsChanged { get; private set; }

    /// <summary>Puts another formula in the place of this one.</summary>
    public void Is(F other)
    {
        (Do, IsChanged) = (other, true);
        foreach (var wrap in around) Do = wrap(Do);
    }

    /// <summary>Lays something around this step.</summary>
    /// <param name="wrap">Gets the step as it was; returns the step as it shall be.</param>
    public void Becomes(Func<F, F> wrap)
    {
        around.Add(wrap);
        (Do, IsChanged) = (wrap(Do), true);
    }
}
