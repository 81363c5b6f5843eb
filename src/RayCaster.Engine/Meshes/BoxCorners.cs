using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>A corner of each of some boxes, the numbers of each axis side by side.</summary>
/// <param name="count">How many boxes.</param>
internal readonly struct BoxCorners(int count)
{
    private readonly double[] x = new double[count], y = new double[count], z = new double[count];

    /// <summary>Sets that of a box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(int box, Vector256<double> corner) => (x[box], y[box], z[box]) = (corner[0], corner[1], corner[2]);

    /// <summary>Those of the boxes, one to each lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> Load<N>() where N : struct, IPacket<N> => new(N.Load(x, 0), N.Load(y, 0), N.Load(z, 0));
}
