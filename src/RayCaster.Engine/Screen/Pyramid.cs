namespace RayCaster.Engine;

/// <summary>The four planes through the eye that hold the rays of some pixels between them, and a pixel around each: more than any rounding, if the
/// camera's pixels can be told apart (<see cref="ScreenSpace.IsFine"/>).</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Pyramid(Camera camera, PixelRect pixels)
{
    // Normals, which point outwards. A point p is at u = p·U / −p·W, so it is to the right of u where p · (U + u W) > 0.
    private readonly Vector3 left = -(camera.U + U(camera, pixels.Column - 1) * camera.W), right = camera.U + U(camera, pixels.EndColumn) * camera.W;
    private readonly Vector3 bottom = -(camera.V + V(camera, pixels.Row - 1) * camera.W), top = camera.V + V(camera, pixels.EndRow) * camera.W;

    /// <summary>Where boxes, seen from the eye, certainly lie outside.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N IsOutside<N>(Vector3<N> low, Vector3<N> high) where N : struct, IReal<N> =>
        (Least(left, low, high) > 0) | (Least(right, low, high) > 0) | (Least(bottom, low, high) > 0) | (Least(top, low, high) > 0);

    /// <summary>The least that n·p can be in a box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static N Least<N>(Vector3 n, Vector3<N> low, Vector3<N> high) where N : struct, IReal<N> =>
        n.X * (n.X > 0 ? low.X : high.X) + n.Y * (n.Y > 0 ? low.Y : high.Y) + n.Z * (n.Z > 0 ? low.Z : high.Z);

    private static double U(Camera camera, int column) => camera.PlaneWidth * ((column + camera.SampleOffset) / camera.Width - 0.5);

    private static double V(Camera camera, int row) => camera.PlaneHeight * ((row + camera.SampleOffset) / camera.Height - 0.5);
}
