using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Names for the steps of a formula, as the slides call them. They are what an explanation shows; they compute nothing.</summary>
public static class Naming
{
    /// <summary>Calls a number by a name.</summary>
    /// <param name="value">The number.</param>
    /// <param name="name">Its letter on the slide.</param>
    /// <param name="formula">How it is computed, as written in the code; the compiler fills it in.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N As<N>(this N value, string name, [CallerArgumentExpression(nameof(value))] string formula = "")
        where N : struct, IReal<N> => N.Named(value, name, formula);

    /// <summary>Calls a vector by a name.</summary>
    /// <inheritdoc cref="As{N}(N, string, string)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<N> As<N>(this Vector3<N> value, string name, [CallerArgumentExpression(nameof(value))] string formula = "")
        where N : struct, IReal<N> => N.Named(value, name, formula);
}
