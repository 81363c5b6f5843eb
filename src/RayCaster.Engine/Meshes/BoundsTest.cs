using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>Asks for the rays of a packet whether bounds can be rejected.</summary>
internal readonly struct BoundsTest
{
    private readonly Packet inverseX, inverseY, inverseZ;
    private readonly Packet mostlyX, ratherY; // masks: the axis that a ray follows most, as AlongRay chooses it

    /// <param name="direction">The rays' directions; they share one origin.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public BoundsTest(Vector3<Packet> direction)
    {
        var (x, y, z) = (Packet.Max(direction.X, -direction.X), Packet.Max(direction.Y, -direction.Y), Packet.Max(direction.Z, -direction.Z));
        (mostlyX, ratherY) = ((x >= y) & (x >= z), y >= z);
        (inverseX, inverseY, inverseZ) = ((Packet)1 / direction.X, (Packet)1 / direction.Y, (Packet)1 / direction.Z);
    }

    /// <summary>Whether any of the rays may cross what is in the bounds, not behind its origin and not beyond <paramref name="nearest"/>.</summary>
    /// <param name="bounds">The bounds, seen from the rays' origin and padded.</param>
    /// <param name="nearest">The t beyond which nothing is looked for.</param>
    /// <remarks>
    /// A ray within a face's plane multiplies 0 by ∞: NaN, which no comparison rejects. A triangle that is seen nearly edge-on may
    /// have a t that is far off the truth, but never outside of what its corners span along the axis that the ray follows most; so only that axis tells
    /// what is too far or behind.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool MayHit(Bounds bounds, Packet nearest)
    {
        var (x0, x1) = (bounds.Min.X * inverseX, bounds.Max.X * inverseX);
        var (y0, y1) = (bounds.Min.Y * inverseY, bounds.Max.Y * inverseY);
        var (z0, z1) = (bounds.Min.Z * inverseZ, bounds.Max.Z * inverseZ);
        var (nearX, farX) = (Packet.Min(x0, x1), Packet.Max(x0, x1));
        var (nearY, farY) = (Packet.Min(y0, y1), Packet.Max(y0, y1));
        var (nearZ, farZ) = (Packet.Min(z0, z1), Packet.Max(z0, z1));
        var missed = Packet.Max(nearX, Packet.Max(nearY, nearZ)) > Packet.Min(farX, Packet.Min(farY, farZ));
        var tooFar = Packet.Select(mostlyX, nearX, Packet.Select(ratherY, nearY, nearZ)) > nearest;
        var behind = Packet.Select(mostlyX, farX, Packet.Select(ratherY, farY, farZ)) < 0;
        return !Packet.All(missed | tooFar | behind);
    }
}
