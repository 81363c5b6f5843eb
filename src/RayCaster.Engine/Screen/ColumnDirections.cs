namespace RayCaster.Engine;

/// <summary>What the rays of a column have in common: uc U (<see cref="Camera.Across"/>).</summary>
internal sealed class ColumnDirections(Camera camera, int capacity)
{
    private readonly double[] x = new double[capacity], y = new double[capacity], z = new double[capacity];

    /// <summary>Computes columns; those of the last packet may lie beyond the width.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Begin<N>(int column, int width) where N : struct, IPacket<N>
    {
        for (var i = 0; i < width; i += N.Count)
        {
            var across = camera.Across(N.Sequence(column + i));
            across.X.Store(x, i);
            across.Y.Store(y, i);
            across.Z.Store(z, i);
        }
    }

    /// <summary>uc U of the packet that begins i columns after the first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3<N> At<N>(int i) where N : struct, IPacket<N> => new(N.Load(x, i), N.Load(y, i), N.Load(z, i));
}
