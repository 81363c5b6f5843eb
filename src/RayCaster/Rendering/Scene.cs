namespace RayCaster;

/// <summary>A world and the camera that looks at it.</summary>
/// <param name="Camera">Where the picture is taken from.</param>
/// <param name="Models">What the world holds; of two models at the same distance the first shows.</param>
/// <param name="Background">The colour of a pixel whose ray hits nothing.</param>
public sealed record Scene(Camera Camera, IReadOnlyList<Model> Models, Color Background = default);
