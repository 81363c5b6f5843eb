using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>The steps that mistakes change, in pipeline order. Each is made when it is needed first; if two threads make one
/// at a time, both are the definition's.</summary>
internal sealed partial class Lab
{
    // ---- Vectors ----

    /// <summary>a → |a|.</summary>
    public Step<Func<Vector3, double>> Length => field ??= new(a => a.Length);

    /// <summary>a → a / |a|.</summary>
    public Step<Func<Vector3, Vector3>> Unit => field ??= new(a => a / Length.Do(a));

    /// <summary>(a, b) → a × b.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> Cross => field ??= new((a, b) => a % b);

    // ---- The camera ----

    /// <summary>(P, T) → T − P.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> ToTarget => field ??= new((p, t) => t - p);

    /// <summary>That → W.</summary>
    public Step<Func<Vector3, Vector3>> AxisW => field ??= new(toTarget => -Unit.Do(toTarget));

    /// <summary>(up, W) → U.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> AxisU => field ??= new((up, w) => Unit.Do(Cross.Do(up, w)));

    /// <summary>(W, U) → V.</summary>
    public Step<Func<Vector3, Vector3, Vector3>> AxisV => field ??= new((w, u) => Cross.Do(w, u));

    /// <summary>fovY in degrees → h.</summary>
    public Step<Func<double, double>> PlaneHeight => field ??= new(fovY => 2 * Math.Tan(fovY * Math.PI / 180 / 2));

    /// <summary>h → w.</summary>
    public Step<Func<double, double>> PlaneWidth => field ??= new(h => h * Camera.Width / Camera.Height);

    /// <summary>(c, r) → the place in the picture, in pixels, that the ray passes.</summary>
    public Step<Func<double, double, (double C, double R)>> Sample => field ??= new((c, r) => (c + half, r + half));

    /// <summary>c → uc.</summary>
    public Step<Func<double, double>> Uc => field ??= new(c => w * c / Camera.Width - w / 2);

    /// <summary>r → ur.</summary>
    public Step<Func<double, double>> Ur => field ??= new(r => h * r / Camera.Height - h / 2);

    /// <summary>(uc, ur) → d before it is normalised.</summary>
    public Step<Func<double, double, Vector3>> Towards => field ??= new((uc, ur) => uc * U + ur * V - W);

    /// <summary>That → d.</summary>
    public Step<Func<Vector3, Vector3>> Direction => field ??= new(a => Unit.Do(a));

    // ---- The crossings of a ray with a shape ----

    /// <summary>(plane, d) → its crossing.</summary>
    public Step<Func<Plane, Vector3, Crossed>> Plane => field ??= new((plane, d) => plane.Intersect(RayOf(d)));

    /// <summary>(sphere, d) → its crossings.</summary>
    public Step<Func<Sphere, Vector3, Crossed>> Sphere => field ??= new((sphere, d) => sphere.Intersect(RayOf(d)));

    /// <summary>(box, d) → its crossings.</summary>
    public Step<Func<Aabb, Vector3, Crossed>> Box => field ??= new((box, d) => box.Intersect(RayOf(d)));

    /// <summary>(circle, d) → its crossing.</summary>
    public Step<Func<Circle, Vector3, Crossed>> Circle => field ??= new((circle, d) => circle.Intersect(RayOf(d)));

    /// <summary>(triangle, d) → its crossing; those of a mesh too.</summary>
    public Step<Func<Triangle, Vector3, Crossed>> Triangle => field ??= new((triangle, d) => triangle.Intersect(RayOf(d)));

    // ---- Which crossing counts ----

    /// <summary>(t, d) → how far t is along the view direction.</summary>
    public Step<Func<double, Vector3, double>> Depth => field ??= new((t, d) => t * -(d * W));

    /// <summary>t → whether it is ahead: t &gt; bias.</summary>
    public Step<Func<double, bool>> Ahead => field ??= new(t => clip.IsAhead<Scalar>(t).Holds);

    /// <summary>(t, depth) → whether it is not nearer than zNear, which measures one of both.</summary>
    public Step<Func<double, double, bool>> Near => field ??= new(
        (t, depth) => clip.IsBeyondNear<Scalar>(Camera.Clip == ClipMode.Depth ? depth : t).Holds);

    /// <summary>(t, depth) → whether it is not beyond zFar, which measures one of both.</summary>
    public Step<Func<double, double, bool>> Far => field ??= new(
        (t, depth) => clip.IsWithinFar<Scalar>(Camera.Clip == ClipMode.Depth ? depth : t).Holds);

    /// <summary>(t, depth) → whether it is between both.</summary>
    public Step<Func<double, double, bool>> Clipped => field ??= new((t, depth) => Near.Do(t, depth) && Far.Do(t, depth));

    /// <summary>(crossings, d) → the first that counts; null for none.</summary>
    public Step<Func<Crossed, Vector3, double?>> First => field ??= new((crossed, d) =>
        Counts(crossed.Near, d) ? crossed.Near : Counts(crossed.Far, d) ? crossed.Far : null);

    /// <summary>(model, d) → the t at which it is hit; null for none. A t of NaN is a hit, too.</summary>
    public Step<Func<Model, Vector3, double?>> Hit => field ??= new(HitOf);

    // ---- Which hit shows ----

    /// <summary>→ the best t before the first hit.</summary>
    public Step<Func<double>> Start => field ??= new(() => double.PositiveInfinity);

    /// <summary>(t, best t) → whether the model hit at t takes the place of the best one.</summary>
    public Step<Func<double, double, bool>> Better => field ??= new((t, best) => t < best);

    /// <summary>(t, best t) → whether t takes the place of the best t.</summary>
    public Step<Func<double, double, bool>> Replaces => field ??= new((t, best) => Better.Do(t, best));

    /// <summary>(t, best t) → whether t is the one that the colour is computed from, if no later one is.</summary>
    public Step<Func<double, double, bool>> Lights => field ??= new((t, best) => Replaces.Do(t, best));

    /// <summary>(t, depth) → whether the hit that was chosen shows.</summary>
    public Step<Func<double, double, bool>> Kept => field ??= new((_, _) => true);

    // ---- The colour ----

    /// <summary>(t, d) → what the attenuation measures.</summary>
    public Step<Func<double, Vector3, double>> Distance => field ??= new((t, _) => t);

    /// <summary>→ 2 |T − P|, the distance at which all light is gone.</summary>
    public Step<Func<double>> FadeDistance => field ??= new(() => Length.Do(2 * (T - P)));

    /// <summary>The distance → the attenuation.</summary>
    public Step<Func<double, double>> Attenuation => field ??= new(t => 1 - t / reach);

    /// <summary>That → the same, not below 0.</summary>
    public Step<Func<double, double>> Dark => field ??= new(attenuation => Math.Max(0, attenuation));

    /// <summary>(t, d, the model's colour) → the hit's colour.</summary>
    public Step<Func<double, Vector3, Color, Color>> Shaded => field ??= new((t, d, color) =>
        Dark.Do(Attenuation.Do(Distance.Do(t, d))) * color);

    /// <summary>A channel → the same between 0 and 1.</summary>
    public Step<Func<double, double>> Clamp => field ??= new(channel => Math.Min(Math.Max(channel, 0), 1));

    /// <summary>That → its byte.</summary>
    public Step<Func<double, byte>> Byte => field ??= new(channel => (byte)(channel * 255 + 0.5)); // NaN becomes 0

    /// <summary>A colour → its bytes.</summary>
    public Step<Func<Color, (byte R, byte G, byte B)>> Encoded => field ??= new(color => (ToByte(color.R), ToByte(color.G), ToByte(color.B)));

    // ---- The file ----

    /// <summary>The column x of the file → c.</summary>
    public Step<Func<int, int>> Column => field ??= new(x => x);

    /// <summary>The line y of the file, 0 = top → r, 0 = bottom.</summary>
    public Step<Func<int, int>> Row => field ??= new(y => Camera.Height - 1 - y);

    /// <summary>(x, y) → what the file shows there.</summary>
    public Step<Func<int, int, (byte R, byte G, byte B)>> Shown => field ??= new((x, y) => Cast(Column.Do(x), Row.Do(y)));

    /// <summary>(x, y) → what a program that reads the file's bytes finds there.</summary>
    public Step<Func<int, int, (byte R, byte G, byte B)>> Read => field ??= new((x, y) => Shown.Do(x, y));
}
