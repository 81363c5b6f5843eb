using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Floats of sixteen pixels side by side and of the sixteen above them. A formula over it is much faster than over doubles, and
/// <see cref="ErrorBound"/> bounds its error. (Two rows share the broadcasts of a formula's constants, a sixth of the work.)</summary>
/// <param name="lower">The numbers of the lower row; as a mask all bits of a lane set for true, none for false.</param>
/// <param name="upper">Those of the upper row.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct FloatPacket(Vector512<float> lower, Vector512<float> upper) : IReal<FloatPacket>
{
    public readonly Vector512<float> Lower = lower, Upper = upper;

    public static int Count => Vector512<float>.Count;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator FloatPacket(double value) => Of(Vector512.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator +(FloatPacket a, FloatPacket b) => new(a.Lower + b.Lower, a.Upper + b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a, FloatPacket b) => new(a.Lower - b.Lower, a.Upper - b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator -(FloatPacket a) => new(-a.Lower, -a.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator *(FloatPacket a, FloatPacket b) => new(a.Lower * b.Lower, a.Upper * b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator /(FloatPacket a, FloatPacket b) => new(a.Lower / b.Lower, a.Upper / b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <(FloatPacket a, FloatPacket b) =>
        new(Vector512.LessThan(a.Lower, b.Lower), Vector512.LessThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >(FloatPacket a, FloatPacket b) =>
        new(Vector512.GreaterThan(a.Lower, b.Lower), Vector512.GreaterThan(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator <=(FloatPacket a, FloatPacket b) =>
        new(Vector512.LessThanOrEqual(a.Lower, b.Lower), Vector512.LessThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator >=(FloatPacket a, FloatPacket b) =>
        new(Vector512.GreaterThanOrEqual(a.Lower, b.Lower), Vector512.GreaterThanOrEqual(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator &(FloatPacket a, FloatPacket b) => new(a.Lower & b.Lower, a.Upper & b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket operator |(FloatPacket a, FloatPacket b) => new(a.Lower | b.Lower, a.Upper | b.Upper);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Sqrt(FloatPacket x) => new(Vector512.Sqrt(x.Lower), Vector512.Sqrt(x.Upper));

    /// <summary>There is no NaN where <see cref="ErrorBound"/> is finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Min(FloatPacket a, FloatPacket b) =>
        new(Vector512.MinNative(a.Lower, b.Lower), Vector512.MinNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Max(FloatPacket a, FloatPacket b) =>
        new(Vector512.MaxNative(a.Lower, b.Lower), Vector512.MaxNative(a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Select(FloatPacket mask, FloatPacket a, FloatPacket b) =>
        new(Vector512.ConditionalSelect(mask.Lower, a.Lower, b.Lower), Vector512.ConditionalSelect(mask.Upper, a.Upper, b.Upper));

    [MethodImpl(MethodImplOptions.AggressiveInlining)] // the interface's default would not be inlined
    public static FloatPacket If(FloatPacket mask, FloatPacket value) => Select(mask, value, double.NaN);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Or(FloatPacket value, FloatPacket instead) => Select(value <= double.PositiveInfinity, value, instead);

    /// <summary>The same in both rows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatPacket Of(Vector512<float> row) => new(row, row);

    /// <summary>One division and three products, each of which rounds.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3<FloatPacket> Divide(Vector3<FloatPacket> a, FloatPacket b) => (FloatPacket)1 / b * a;
}
