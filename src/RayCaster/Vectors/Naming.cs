namespace RayCaster;

/// <summary>Gives the steps of a formula the names of the slides. Explanations show them; they do not change what is computed.</summary>
public static class Naming
{
    /// <summary>Names a number.</summary>
    /// <param name="name">Its letter on the slide.</param>
    /// <param name="formula">The source text of the value; the compiler fills it in.</param>
    public static N As<N>(this N value, string name, [CallerArgumentExpression(nameof(value))] string formula = "")
        where N : struct, IReal<N> => N.Named(value, name, formula);

    /// <summary>Names a vector.</summary>
    /// <inheritdoc cref="As{N}(N, string, string)"/>
    public static Vector3<N> As<N>(this Vector3<N> value, string name, [CallerArgumentExpression(nameof(value))] string formula = "")
        where N : struct, IReal<N> => N.Named(value, name, formula);
}
