using System.Globalization;

namespace RayCaster.Tests.Numbers;

/// <summary>A number that knows how it came about. A trial of the door that <see cref="IReal{N}"/> leaves open.</summary>
internal readonly record struct Derivation(double Value, string Text) : IReal<Derivation>
{
    public static implicit operator Derivation(double value) => new(value, value.ToString("R", CultureInfo.InvariantCulture));

    public static Derivation operator +(Derivation a, Derivation b) => new(a.Value + b.Value, $"({a.Text} + {b.Text})");

    public static Derivation operator -(Derivation a, Derivation b) => new(a.Value - b.Value, $"({a.Text} - {b.Text})");

    public static Derivation operator -(Derivation a) => new(-a.Value, $"-{a.Text}");

    public static Derivation operator *(Derivation a, Derivation b) => new(a.Value * b.Value, $"{a.Text} * {b.Text}");

    public static Derivation operator /(Derivation a, Derivation b) => new(a.Value / b.Value, $"{a.Text} / {b.Text}");

    public static Derivation operator <(Derivation a, Derivation b) => Mask(a.Value < b.Value, a, "<", b);

    public static Derivation operator >(Derivation a, Derivation b) => Mask(a.Value > b.Value, a, ">", b);

    public static Derivation operator <=(Derivation a, Derivation b) => Mask(a.Value <= b.Value, a, "<=", b);

    public static Derivation operator >=(Derivation a, Derivation b) => Mask(a.Value >= b.Value, a, ">=", b);

    public static Derivation operator &(Derivation a, Derivation b) => Mask(a.Value != 0 && b.Value != 0, a, "and", b);

    public static Derivation operator |(Derivation a, Derivation b) => Mask(a.Value != 0 || b.Value != 0, a, "or", b);

    public static Derivation Sqrt(Derivation x) => new(Math.Sqrt(x.Value), $"sqrt({x.Text})");

    public static Derivation Min(Derivation a, Derivation b) => new(Math.Min(a.Value, b.Value), $"min({a.Text}, {b.Text})");

    public static Derivation Max(Derivation a, Derivation b) => new(Math.Max(a.Value, b.Value), $"max({a.Text}, {b.Text})");

    public static Derivation Select(Derivation mask, Derivation a, Derivation b) =>
        new(mask.Value != 0 ? a.Value : b.Value, $"[{mask.Text}] ? {a.Text} : {b.Text}");

    private static Derivation Mask(bool holds, Derivation a, string sign, Derivation b) => new(holds ? 1 : 0, $"{a.Text} {sign} {b.Text}");
}
