using System.Globalization;
using System.Runtime.Intrinsics;

namespace RayCaster;

#pragma warning disable CS1591 // IReal explains the operators and functions

/// <summary>One double. With it a formula is the definition; every other kind of number must agree with it.</summary>
/// <param name="Value">The number. The bits of a mask are all 1 (true) or all 0 (false).</param>
public readonly record struct Scalar(double Value) : IReal<Scalar>
{
    // Masks are made of bits by vector instructions, of which only the first lane counts: with 1 and 0 as numbers a picture takes 1.3 times as
    // long. AggressiveInlining here and in other files: in a long formula the JIT stops inlining, and a picture with calls takes twice as long.

    /// <summary>Whether this mask is true.</summary>
    public bool Holds => BitConverter.DoubleToInt64Bits(Value) != 0;

    public static implicit operator Scalar(double value) => new(value);

    public static implicit operator double(Scalar scalar) => scalar.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator +(Scalar a, Scalar b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator -(Scalar a, Scalar b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator -(Scalar a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator *(Scalar a, Scalar b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator /(Scalar a, Scalar b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator <(Scalar a, Scalar b) => new(Vector128.LessThan(a.Lane, b.Lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator >(Scalar a, Scalar b) => new(Vector128.GreaterThan(a.Lane, b.Lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator <=(Scalar a, Scalar b) => new(Vector128.LessThanOrEqual(a.Lane, b.Lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator >=(Scalar a, Scalar b) => new(Vector128.GreaterThanOrEqual(a.Lane, b.Lane));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator &(Scalar a, Scalar b) => new(a.Lane & b.Lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar operator |(Scalar a, Scalar b) => new(a.Lane | b.Lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar Sqrt(Scalar x) => new(Math.Sqrt(x.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar Min(Scalar a, Scalar b) => new(Math.Min(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar Max(Scalar a, Scalar b) => new(Math.Max(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Scalar Select(Scalar mask, Scalar a, Scalar b) => new(Vector128.ConditionalSelect(mask.Lane, a.Lane, b.Lane));

    public override string ToString() => Value.ToString(CultureInfo.InvariantCulture);

    private Vector128<double> Lane => Vector128.CreateScalarUnsafe(Value);

    private Scalar(Vector128<double> lane) : this(lane.ToScalar()) { }
}
