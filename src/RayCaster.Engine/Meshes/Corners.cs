namespace RayCaster.Engine;

/// <summary>Where the corners of triangles are seen.</summary>
internal abstract class Corners
{
    public abstract int Count { get; }

    /// <param name="seen">Their corners on the screen; meaningless where a corner is not fit for floats.</param>
    public abstract void See(ReadOnlySpan<int> triangles, out EightTriangles seen);

    /// <summary>Fetches the indices of triangles that will be needed soon.</summary>
    public virtual void Fetch(int first, int count)
    {
    }

    /// <summary>Fetches the vertices of triangles that will be needed next.</summary>
    public virtual void FetchVertices(int first, int count)
    {
    }
}
