using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>The steps that mistakes change, in the order of the way of the data.</summary>
internal sealed partial class Lab
{
    // ---- Vectors ----

    /// <summary>a → |a|.</summary>
    public Step<Func<Vector3, double>> Length { get; } = new(a => a.Length);

    /// <summary>a → a / |a|.</summary>
    public Step<Func<Vector3, Vector3>> Unit { get; }

    /// <summary>(a, b) → a × b.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> Cross { get; } = new((a, b) => a % b);

    // ---- The camera ----

    /// <summary>(P, T) → W.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> AxisW { get; }

    /// <summary>(up, W) → U.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> AxisU { get; }

    /// <summary>(W, U) → V.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> AxisV { get; }

    /// <summary>An angle → its tangent.</summary>
    public Step<Func<double, double>> Tan { get; } = new(Math.Tan);

    /// <summary>fovY in degrees → h.</summary>
    public Step<Func<double, double>> PlaneHeight { get; }

    /// <summary>h → w.</summary>
    public Step<Func<double, double>> PlaneWidth { get; }

    /// <summary>(c, r) → the place in the picture, in pixels, that the ray passes.</summary>
    public Step<Func<double, double, (double C, double R)>> Sample { get; }

    /// <summary>c → uc.</summary>
    public Step<Func<double, double>> Uc { get; }

    /// <summary>r → ur.</summary>
    public Step<Func<double, double>> Ur { get; }

    /// <summary>(uc, ur) → d before it is normalised.</summary>
    public Step<Func<double, double, Vector3>> Towards { get; }

    /// <summary>That → d.</summary>
    public Step<Func<Vector3, Vector3>> Direction { get; }

    // ---- The crossings of a ray with a shape ----

    /// <summary>(plane, d) → its crossing.</summary>
    public Step<Func<Plane, Vector3, Crossed>> Plane { get; }

    /// <summary>(sphere, d) → its crossings.</summary>
    public Step<Func<Sphere, Vector3, Crossed>> Sphere { get; }

    /// <summary>(box, d) → its crossings.</summary>
    public Step<Func<Aabb, Vector3, Crossed>> Box { get; }

    /// <summary>(circle, d) → its crossing.</summary>
    public Step<Func<Circle, Vector3, Crossed>> Circle { get; }

    /// <summary>(triangle, d) → its crossing; those of a mesh too.</summary>
    public Step<Func<Triangle, Vector3, Crossed>> Triangle { get; }

    // ---- Which crossing counts ----

    /// <summary>(t, d) → how far t is along the view direction.</summary>
    public Step<Func<double, Vector3, double>> Depth { get; }

    /// <summary>t → whether it is ahead: t &gt; bias.</summary>
    public Step<Func<double, bool>> Ahead { get; }

    /// <summary>(t, depth) → whether it is not nearer than zNear, which measures one of both.</summary>
    public Step<Func<double, double, bool>> Near { get; }

    /// <summary>(t, depth) → whether it is not beyond zFar, which measures one of both.</summary>
    public Step<Func<double, double, bool>> Far { get; }

    /// <summary>(t, depth) → whether it is between both.</summary>
    public Step<Func<double, double, bool>> Clipped { get; }

    /// <summary>(crossings, d) → the first that counts; null for none.</summary>
    public Step<Func<Crossed, Vector3, double?>> First { get; }

    /// <summary>(model, d) → the t at which it is hit; null for none. A t that is no number is a hit too.</summary>
    public Step<Func<Model, Vector3, double?>> Hit { get; }

    // ---- Which hit shows ----

    /// <summary>→ the best t before the first hit.</summary>
    public Step<Func<double>> Start { get; } = new(() => double.PositiveInfinity);

    /// <summary>(t, best t) → whether the model hit at t takes the place of the best one.</summary>
    public Step<Func<double, double, bool>> Better { get; } = new((t, best) => t < best);

    /// <summary>(t, best t) → whether t takes the place of the best t.</summary>
    public Step<Func<double, double, bool>> Replaces { get; }

    /// <summary>(t, best t) → whether t is the one that the colour is computed from, if no later one is.</summary>
    public Step<Func<double, double, bool>> Lights { get; }

    /// <summary>(t, depth) → whether the hit that was chosen shows.</summary>
    public Step<Func<double, double, bool>> Kept { get; } = new((_, _) => true);

    // ---- The colour ----

    /// <summary>(t, d) → what the attenuation measures.</summary>
    public Step<Func<double, Vector3, double>> Distance { get; } = new((t, _) => t);

    /// <summary>→ 2 |T − P|, the distance at which all light is gone.</summary>
    public Step<Func<double>> Reach { get; }

    /// <summary>The distance → the attenuation.</summary>
    public Step<Func<double, double>> Attenuation { get; }

    /// <summary>That → the same, not below 0.</summary>
    public Step<Func<double, double>> Dark { get; } = new(attenuation => Math.Max(0, attenuation));

    /// <summary>(attenuation, the model's colour) → the hit's colour.</summary>
    public Step<Func<double, Color, Color>> Lit { get; } = new((attenuation, color) => attenuation * color);

    /// <summary>A channel → the same between 0 and 1.</summary>
    public Step<Func<double, double>> Clamp { get; } = new(channel => Math.Min(Math.Max(channel, 0), 1));

    /// <summary>That → its byte.</summary>
    public Step<Func<double, byte>> Byte { get; } = new(channel => (byte)(channel * 255 + 0.5)); // no number becomes 0

    // ---- The file ----

    /// <summary>The column x of the file → c.</summary>
    public Step<Func<int, int>> Column { get; } = new(x => x);

    /// <summary>The line y of the file, 0 = top → r, 0 = bottom.</summary>
    public Step<Func<int, int>> Row { get; }

    /// <summary>(x, y) → what the file shows there.</summary>
    public Step<Func<int, int, (byte R, byte G, byte B)>> Shown { get; }
}
