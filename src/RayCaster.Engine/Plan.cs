namespace RayCaster.Engine;

/// <summary>The rendering strategy of a picture.</summary>
/// <param name="Threads">How many threads cast rays.</param>
/// <param name="KeepsLists">Whether what depends only on a mesh or on the list of models stays in memory for the next picture.</param>
/// <param name="UsesShapeKernels">Whether kernels for single kinds of shape are compiled: they save half of the time, but
/// compiling them takes as long as casting some ten million rays.</param>
/// <param name="UsesIntervals">Whether the formulas over intervals, which drop models that cannot show in a part of a tile, are compiled: compiling
/// those of five kinds of shape takes as long as intersecting some hundred million rays with a model.</param>
/// <param name="UsesBatch">Whether models are found by their places on the screen.</param>
/// <param name="IsWide">Whether packets hold eight doubles, not four.</param>
internal sealed record Plan(int Threads, bool KeepsLists, bool UsesShapeKernels, bool UsesIntervals, bool UsesBatch, bool IsWide)
{
    /// <summary>A picture of at least this many pixels is worth compiling kernels for.</summary>
    private const long PixelsOfLongWork = 1 << 24;

    /// <summary>With at least this many pixels times models, intervals are worth compiling.</summary>
    private const long IntersectionsOfLongWork = 1 << 27;

    /// <summary>With fewer models, testing each of them is cheaper than lists for parts of the picture.</summary>
    private const int FewModels = 64;

    public static Plan For(Scene scene, int threads, bool manyFrames) => new(
        threads,
        KeepsLists: manyFrames,
        UsesShapeKernels: IsCompiled(manyFrames) || PixelsOf(scene) >= PixelsOfLongWork,
        UsesIntervals: IsCompiled(manyFrames) || PixelsOf(scene) * scene.Models.Count >= IntersectionsOfLongWork,
        UsesBatch: scene.Models.Count > FewModels && !scene.Camera.IsSkewed,
        IsWide: Vector512.IsHardwareAccelerated);

    /// <summary>Whether all code is compiled before, or is worth compiling for the pictures that follow.</summary>
    private static bool IsCompiled(bool manyFrames) => manyFrames || !RuntimeFeature.IsDynamicCodeCompiled;

    private static long PixelsOf(Scene scene) => (long)scene.Camera.Width * scene.Camera.Height;
}
