using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The rays of a part; the numbers of each row begin at a multiple of <see cref="CrowdPart.Side"/>.</summary>
internal readonly struct CrowdRays(Vector3 origin)
{
    private const int Length = CrowdPart.Side * CrowdPart.Side;

    private readonly Vector3 origin = origin;
    private readonly double[] x = new double[Length], y = new double[Length], z = new double[Length], zPerT = new double[Length];

    /// <summary>Where all of them start.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Origin<N>() where N : struct, IReal<N> => origin;

    /// <summary>The directions of a packet.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> DirectionsAt<N>(int packet) where N : struct, IPacket<N> =>
        new(N.Load(x, packet), N.Load(y, packet), N.Load(z, packet));

    /// <summary>What their z gains for one unit of t.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ZPerTAt<N>(int packet) where N : struct, IPacket<N> => N.Load(zPerT, packet);

    /// <summary>Sets both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set<N>(int packet, Vector3<N> direction, N zPerT) where N : struct, IPacket<N>
    {
        direction.X.Store(x, packet);
        direction.Y.Store(y, packet);
        direction.Z.Store(z, packet);
        zPerT.Store(this.zPerT, packet);
    }
}
