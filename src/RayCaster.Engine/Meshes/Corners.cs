using System.Runtime.Intrinsics;

namespace RayCaster.Engine;

/// <summary>Where the corners of triangles are seen.</summary>
internal abstract class Corners
{
    public abstract int Count { get; }

    /// <summary>Sees eight triangles.</summary>
    /// <param name="seen">Their corners on the screen. Where one is not fit for floats the numbers mean nothing.</param>
    public abstract void See(ReadOnlySpan<int> triangles, out EightTriangles seen);

    /// <summary>Sees eight triangles that follow one another; where fewer are left, the last one again in the other lanes.</summary>
    public void SeeRun(int first, out EightTriangles seen)
    {
        Span<int> triangles = stackalloc int[8];
        Vector256.Min(Vector256.Create(first) + Vector256<int>.Indices, Vector256.Create(Count - 1)).CopyTo(triangles);
        See(triangles, out seen);
    }

    /// <summary>Says that a group will be seen soon; <see cref="FetchVertices"/> is to follow.</summary>
    /// <param name="group">Its first triangle.</param>
    public virtual void Fetch(int group)
    {
    }

    /// <summary>Says that a group will be seen next, or almost.</summary>
    /// <param name="group">Its first triangle.</param>
    public virtual void FetchVertices(int group)
    {
    }
}
