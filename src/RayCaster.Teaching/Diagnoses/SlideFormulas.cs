using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>Small pieces of the slides' algebra that several mistakes are made of.</summary>
internal static class SlideFormulas
{
    /// <summary>A coordinate: 0 is x, 1 is y, 2 is z.</summary>
    public static double At(this Vector3 a, int axis) => axis switch { 0 => a.X, 1 => a.Y, _ => a.Z };

    /// <summary>No crossing.</summary>
    public static Crossed None => new(double.NaN);

    /// <summary>The crossings, or none if the near one lies behind the camera.</summary>
    public static Crossed UnlessBehind(Crossed crossed) => (double)crossed.Near < 0 ? None : crossed;

    /// <summary>The least of three; NaN if one of them is NaN.</summary>
    public static double Least(double x, double y, double z) => Math.Min(Math.Min(x, y), z);
}
