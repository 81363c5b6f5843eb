using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>The nearest hits so far of the rays of a part, which lie as <see cref="CrowdRays"/> do.</summary>
internal readonly struct CrowdHits()
{
    private readonly double[] t = new double[CrowdPart.Side * CrowdPart.Side], models = new double[CrowdPart.Side * CrowdPart.Side];

    /// <summary>Sets all t.</summary>
    public void Fill(double nearest) => Array.Fill(t, nearest);

    /// <summary>Sets some t.</summary>
    public void Fill(int first, int count, double nearest) => Array.Fill(t, nearest, first, count);

    /// <summary>The t of a packet's hits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N NearestAt<N>(int packet) where N : struct, IPacket<N> => N.Load(t, packet);

    /// <summary>Their models.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N ModelsAt<N>(int packet) where N : struct, IPacket<N> => N.Load(models, packet);

    /// <summary>Sets both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set<N>(int packet, N nearest, N model) where N : struct, IPacket<N>
    {
        nearest.Store(t, packet);
        model.Store(models, packet);
    }

    /// <summary>Keeps the hits of a model that are nearer than all before; see <see cref="RaySpan.Keep"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Keep<N>(int packet, N hit, N model) where N : struct, IPacket<N>
    {
        var (nearest, first) = (NearestAt<N>(packet), ModelsAt<N>(packet));
        var better = (hit < nearest) | (N.Equal(hit, nearest) & (model < first));
        Set(packet, N.Select(better, hit, nearest), N.Select(better, model, first));
    }
}
