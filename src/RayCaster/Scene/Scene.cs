using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>Models, and the camera that looks at them.</summary>
/// <param name="Models">The models; of two at the same distance the first shows.</param>
/// <param name="Background">The colour of a pixel whose ray hits nothing.</param>
public sealed record Scene(Camera Camera, IReadOnlyList<Model> Models, Color Background = default)
{
    /// <summary>The colour of a pixel (slide "Primitive Shading"): the farther the hit, the darker the model. The background is not
    /// attenuated.</summary>
    /// <param name="model">The model of the nearest hit; null for no hit.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Color Shade(double t, Model? model) => model is null ? Background : Attenuation<Scalar>(t) * model.Color;

    /// <summary>1 − t / (2 |T − P|), not below 0: black at 2 |T − P| and beyond.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N Attenuation<N>(N t) where N : struct, IReal<N> => N.Max(0, 1 - t / Camera.FadeDistance).As("attenuation");

    /// <summary>How many shapes there are; each triangle of a mesh counts.</summary>
    public long ShapeCount => Models.Sum(model => model is Mesh mesh ? mesh.TriangleCount : 1L);

    /// <summary>Where a model is in <see cref="Models"/>, from 0; −1 for null.</summary>
    public int IndexOf(Model? model) => model is null ? -1 : Models.TakeWhile(other => other != model).Count();

    /// <summary>The same scene in a picture of another size.</summary>
    public Scene WithSize(int width, int height) => this with { Camera = Camera.With(width: width, height: height) };
}
