namespace RayCaster;

/// <summary>Where the corners of triangles are seen.</summary>
internal abstract class Corners
{
    /// <summary>How many triangles there are.</summary>
    public abstract int Count { get; }

    /// <summary>Sees eight triangles.</summary>
    /// <param name="triangles">Which ones.</param>
    /// <param name="seen">Their corners on the screen. Where one is not fit for floats the numbers mean nothing.</param>
    public abstract void See(ReadOnlySpan<int> triangles, out EightTriangles seen);
}
