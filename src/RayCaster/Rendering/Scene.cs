using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A world and the camera that looks at it.</summary>
/// <param name="Camera">Where the picture is taken from.</param>
/// <param name="Models">What the world holds; of two models at the same distance the first shows.</param>
/// <param name="Background">The colour of a pixel whose ray hits nothing.</param>
public sealed record Scene(Camera Camera, IReadOnlyList<Model> Models, Color Background = default)
{
    /// <summary>What a pixel shows (slide "Primitive Shading"): the farther the hit, the darker its model.</summary>
    /// <param name="t">The parameter of the nearest hit.</param>
    /// <param name="model">The model hit there; null for none, which shows the background, not attenuated.</param>
    public Color Shade(double t, Model? model) => model is null ? Background : Attenuation<Scalar>(t) * model.Color;

    /// <summary>1 − t / (2 |T − P|), not below 0: black from twice the target's distance on.</summary>
    /// <param name="t">The parameter of the hit; any kind of number.</param>
    /// <typeparam name="N">The kind of number.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public N Attenuation<N>(N t) where N : struct, IReal<N> => N.Max(0, 1 - t / Camera.Reach).As("attenuation");
}
