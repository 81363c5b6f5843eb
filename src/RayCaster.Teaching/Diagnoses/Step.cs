namespace RayCaster.Teaching;

/// <summary>A step of the definition that mistakes change: they replace its formula, or change what goes in or comes out.</summary>
/// <remarks>A change around a formula stays if another mistake replaces the formula later, so the order of two mistakes does not matter.</remarks>
internal sealed class Step<F>(F definition) where F : Delegate
{
    private readonly List<Func<F, F>> around = [];

    public F Do { get; private set; } = definition;

    public bool IsChanged { get; private set; }

    public void Is(F other)
    {
        (Do, IsChanged) = (other, true);
        foreach (var wrap in around) Do = wrap(Do);
    }

    /// <param name="wrap">Gets the old step, and returns the new one.</param>
    public void Becomes(Func<F, F> wrap)
    {
        around.Add(wrap);
        (Do, IsChanged) = (wrap(Do), true);
    }
}
