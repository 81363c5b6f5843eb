namespace RayCaster.Engine;

/// <summary>Where the corners of triangles are seen.</summary>
internal abstract class CornerSource
{
    public abstract int Count { get; }

    /// <param name="seen">Their corners on the screen; meaningless where a corner is not fit for floats.</param>
    public abstract void Project(ReadOnlySpan<int> triangles, out EightTriangles seen);

    /// <summary>Prefetches the indices of triangles that will be needed soon.</summary>
    public virtual void Prefetch(int first, int count)
    {
    }

    /// <summary>Prefetches the vertices of triangles that will be needed next.</summary>
    public virtual void PrefetchVertices(int first, int count)
    {
    }
}
