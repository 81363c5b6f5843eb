namespace RayCaster.Teaching;

/// <summary>Other right ways to the camera's axes, and from them to d: in each a wrong length or cross product shows otherwise.</summary>
internal static class CameraWays
{
    /// <summary>d by the inverse of the matrix with the rows U, V and W: another right way if these are perpendicular and of length 1.</summary>
    public static (string Cause, Action<Lab> Deviate) ByInverse => ("d is made by the inverse of the matrix with the rows U, V and W", lab =>
        lab.Towards.Is((uc, ur) => (uc * (lab.V % lab.W) + ur * (lab.W % lab.U) - lab.U % lab.V) / (lab.U % lab.V * lab.W)));

    /// <summary>V = up − (up·W) W normalised, and U = V × W: another way to the same axes.</summary>
    public static void ProjectUp(Lab lab)
    {
        lab.AxisV.Is((w, _) => lab.Unit.Do(lab.Camera.Up - (lab.Camera.Up * w) * w));
        lab.AxisU.Is((_, w) => lab.Cross.Do(lab.AxisV.Do(w, default), w));
    }

    /// <summary>The camera turned to the right and up in a frame whose third axis is up: another way to the same axes.</summary>
    public static void TurnByAngles(Lab lab)
    {
        var up = lab.Unit.Do(lab.Camera.Up);
        var x = lab.Unit.Do(lab.Cross.Do(Math.Abs(up.X) < 0.9 ? new(1, 0, 0) : new(0, 1, 0), up));
        var (y, f) = (lab.Cross.Do(up, x), lab.T - lab.P);
        var (yaw, pitch) = (Math.Atan2(f * y, f * x), Math.Asin(f * up / f.Length));
        var level = Math.Cos(yaw) * x + Math.Sin(yaw) * y;
        lab.AxisW.Is(_ => -(Math.Cos(pitch) * level + Math.Sin(pitch) * up));
        lab.AxisU.Is((_, _) => Math.Sin(yaw) * x - Math.Cos(yaw) * y);
        lab.AxisV.Is((_, _) => Math.Cos(pitch) * up - Math.Sin(pitch) * level);
    }

    /// <summary>V from yaw and pitch by a cross product, then U and V turned by the roll: another way to the same axes.</summary>
    public static void Roll(Lab lab)
    {
        var (f, up) = (lab.T - lab.P, lab.Camera.Up);
        var (yaw, pitch) = (Math.Atan2(f.Y, f.X), Math.Atan2(f.Z, Math.Sqrt(f.X * f.X + f.Y * f.Y)));
        Vector3 forward = new(Math.Cos(pitch) * Math.Cos(yaw), Math.Cos(pitch) * Math.Sin(yaw), Math.Sin(pitch));
        Vector3 right = new(Math.Sin(yaw), -Math.Cos(yaw), 0);
        var above = lab.Cross.Do(right, forward);
        var roll = Math.Atan2(up * right, up * above);
        lab.AxisW.Is(_ => -forward);
        lab.AxisU.Is((_, _) => Math.Cos(roll) * right - Math.Sin(roll) * above);
        lab.AxisV.Is((_, _) => Math.Sin(roll) * right + Math.Cos(roll) * above);
    }

    /// <summary>The camera's axes without the wrong cross product or length.</summary>
    public static void RightAxes(Lab lab)
    {
        lab.AxisW.Is(toTarget => -toTarget.Normalized);
        lab.AxisU.Is((up, w) => (up % w).Normalized);
        lab.AxisV.Is((w, u) => w % u);
    }
}
