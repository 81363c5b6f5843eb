namespace RayCaster;

/// <summary>Models, and the camera that looks at them.</summary>
/// <param name="Models">The models; of two at the same distance the first shows.</param>
/// <param name="Background">The colour of a pixel whose ray hits nothing.</param>
public sealed record Scene(Camera Camera, IReadOnlyList<Model> Models, Color Background = default)
{
    /// <summary>The colour of a pixel (slide "Primitive Shading"): the farther the hit, the darker the model. The background is not
    /// attenuated.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Color Shade(Hit nearest) => nearest.Model < 0 ? Background : Attenuation<Scalar>(nearest.T) * Models[nearest.Model].Color;

    /// <summary>1 − t / (2 |T − P|), not below 0: black at 2 |T − P| and beyond.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N Attenuation<N>(N t) where N : struct, IReal<N> => N.Max(0, 1 - t / Camera.FadeDistance).As("attenuation");

    /// <summary>How many shapes there are; each triangle of a mesh counts.</summary>
    public long ShapeCount
    {
        get
        {
            var count = 0L;
            for (var i = 0; i < Models.Count; i++) count += Models[i] is Mesh mesh ? mesh.TriangleCount : 1;
            return count;
        }
    }

    /// <summary>The same scene in a picture of another size.</summary>
    public Scene WithSize(int width, int height) => this with { Camera = Camera with { Width = width, Height = height } };
}
