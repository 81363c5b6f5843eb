using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Where the corners of triangles are seen.</summary>
internal abstract class Corners
{
    public abstract int Count { get; }

    /// <summary>Sees eight triangles.</summary>
    /// <param name="seen">Their corners on the screen; meaningless where a corner is not fit for floats.</param>
    public abstract void See(ReadOnlySpan<int> triangles, out EightTriangles seen);

    /// <summary>Projects eight triangles that follow one another; if fewer are left, the last one is repeated.</summary>
    public void SeeRun(int first, out EightTriangles seen)
    {
        Span<int> triangles = stackalloc int[8];
        Vector256.Min(Vector256.Create(first) + Vector256<int>.Indices, Vector256.Create(Count - 1)).CopyTo(triangles);
        See(triangles, out seen);
    }

    /// <summary>Fetches the indices of a cluster that will be needed soon.</summary>
    public virtual void Fetch(int group)
    {
    }

    /// <summary>Fetches the vertices of a cluster that will be needed next.</summary>
    public virtual void FetchVertices(int group)
    {
    }

    /// <summary>Fetches the indices of triangles that will be needed soon, anywhere in the mesh.</summary>
    public virtual void Fetch(ReadOnlySpan<int> triangles)
    {
    }

    /// <summary>Fetches the vertices of triangles that will be needed next, anywhere in the mesh.</summary>
    public virtual void FetchVertices(ReadOnlySpan<int> triangles)
    {
    }
}
