namespace RayCaster;

#pragma warning disable CS1591 // the operators are those of a double

/// <summary>
/// A kind of number. A primitive's formula is written once, over any kind: with one double it is the definition, with a packet of doubles it
/// draws several pixels at once, with an interval it bounds what a whole region of rays can hit, and with a number that records its operations
/// it explains a pixel.
/// </summary>
/// <remarks>
/// <para>The operations are IEEE 754's on doubles, each rounded once, in the written order, so that all kinds made of doubles compute the
/// same bits. There is no fused multiply-add: it would round differently.</para>
/// <para>"No crossing" is NaN (not a number), and every comparison with NaN is false. A comparison gives a mask, for <c>&amp;</c>, <c>|</c>,
/// <see cref="If"/> and <see cref="Select"/> only. A packet has several answers at once, so formulas use Select instead of if.</para>
/// </remarks>
/// <typeparam name="N">The number itself.</typeparam>
public interface IReal<N> where N : struct, IReal<N>
{
    /// <summary>A constant of the formula.</summary>
    static abstract implicit operator N(double value);

    static abstract N operator +(N a, N b);
    static abstract N operator -(N a, N b);
    static abstract N operator -(N a);
    static abstract N operator *(N a, N b);

    /// <summary>Quotient; x / 0 is infinite, 0 / 0 is NaN.</summary>
    static abstract N operator /(N a, N b);

    // The comparisons give masks, false where either is NaN; & and | join masks.
    static abstract N operator <(N a, N b);
    static abstract N operator >(N a, N b);
    static abstract N operator <=(N a, N b);
    static abstract N operator >=(N a, N b);
    static abstract N operator &(N a, N b);
    static abstract N operator |(N a, N b);

    /// <summary>The square root; NaN of a negative number.</summary>
    static abstract N Sqrt(N x);

    /// <summary>The lesser, as <see cref="Math.Min(double, double)"/>: NaN if either is, and −0 is less than 0.</summary>
    static abstract N Min(N a, N b);

    /// <summary>The greater, as <see cref="Math.Max(double, double)"/>: NaN if either is, and 0 is greater than −0.</summary>
    static abstract N Max(N a, N b);

    /// <summary><paramref name="a"/> where the mask holds, <paramref name="b"/> elsewhere.</summary>
    static abstract N Select(N mask, N a, N b);

    /// <summary><paramref name="value"/> where the mask holds, elsewhere NaN: "a crossing here, if …".</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    static virtual N If(N mask, N value) => N.Select(mask, value, double.NaN);

    /// <summary><paramref name="value"/> where it is a number, <paramref name="instead"/> where it is NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    static virtual N IfNaN(N value, N instead) => N.Select(value <= double.PositiveInfinity, value, instead);

    /// <summary>A vector's coordinates, each divided by the same number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    static virtual Vector3<N> Divide(Vector3<N> a, N b) => new(a.X / b, a.Y / b, a.Z / b);

    /// <summary>Gives a step of a formula its name (<see cref="Naming"/>). Only a number that explains uses it.</summary>
    static virtual N Named(N value, string name, string formula) => value;

    /// <inheritdoc cref="Named(N, string, string)"/>
    static virtual Vector3<N> Named(Vector3<N> value, string name, string formula) => value;
}
