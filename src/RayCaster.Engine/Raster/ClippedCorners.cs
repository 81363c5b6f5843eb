namespace RayCaster.Engine;

/// <summary>The corners of triangles that are projected already.</summary>
/// <param name="points">x, y and inverse depth of three corners for each triangle.</param>
internal sealed class ClippedCorners(Vector128<float>[] points) : CornerSource
{
    public override int Count => points.Length / 3;

    public override void Project(ReadOnlySpan<int> triangles, out EightTriangles seen) =>
        (seen.A, seen.B, seen.C) = (Corner(triangles, 0), Corner(triangles, 1), Corner(triangles, 2));

    private EightPoints Corner(ReadOnlySpan<int> triangles, int corner)
    {
        Span<float> numbers = stackalloc float[24];
        for (var i = 0; i < 8; i++)
            for (var k = 0; k < 3; k++)
                numbers[8 * k + i] = points[3 * triangles[i] + corner][k];
        return new(Vector256.Create<float>(numbers), Vector256.Create<float>(numbers[8..]), Vector256.Create<float>(numbers[16..]));
    }
}
