namespace RayCaster.Files;

/// <summary>A camera moved by hand: turned about its target, brought nearer, shifted with its target.</summary>
public static class CameraMotion
{
    /// <summary>How near the view may come to the direction that is up, where the picture would turn over, in radians.</summary>
    private const double LeastAngle = 0.01;

    /// <summary>Goes around the target.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="around">About the direction that is up, in radians, counterclockwise seen from above.</param>
    /// <param name="over">Towards up, in radians; it ends shortly before the view is parallel to up.</param>
    public static Camera Turn(Camera camera, double around, double over)
    {
        var axis = camera.Up.Normalized;
        var v = camera.Position - camera.Target;
        var angle = Math.Acos(Math.Clamp(axis * v.Normalized, -1, 1)); // between up and the way back to the camera
        var to = Math.Clamp(angle - over, LeastAngle, Math.PI - LeastAngle);
        v = Rotate(v, camera.U, to - angle);
        return At(camera, camera.Target + Rotate(v, axis, around), camera.Target);
    }

    /// <summary>Goes nearer to the target, or away from it.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="factor">By what the distance is multiplied.</param>
    public static Camera Approach(Camera camera, double factor) =>
        At(camera, camera.Target + factor * (camera.Position - camera.Target), camera.Target);

    /// <summary>Shifts camera and target across the view, by parts of the picture's height at the target.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="right">To the right, along U.</param>
    /// <param name="up">Upwards, along V.</param>
    public static Camera Shift(Camera camera, double right, double up)
    {
        var height = camera.PlaneHeight * (camera.Target - camera.Position).Length;
        var shift = right * height * camera.U + up * height * camera.V;
        return At(camera, camera.Position + shift, camera.Target + shift);
    }

    /// <summary>The same camera with coordinates of so few digits that a person can read them: a ten-thousandth of the distance from the
    /// target.</summary>
    public static Camera Rounded(Camera camera)
    {
        var distance = (camera.Target - camera.Position).Length;
        var digits = (int)Math.Clamp(4 - Math.Floor(Math.Log10(distance)), 0, 15);
        return At(camera, Round(camera.Position), Round(camera.Target));

        Vector3 Round(Vector3 v) => new(Math.Round(v.X, digits), Math.Round(v.Y, digits), Math.Round(v.Z, digits));
    }

    /// <summary>The camera at another place; where no picture can be taken from there it stays.</summary>
    private static Camera At(Camera camera, Vector3 position, Vector3 target)
    {
        var moved = new Camera(camera.Parameters with { Position = position, Target = target });
        return moved.Flaw is null ? moved : camera;
    }

    /// <summary>Rodrigues: v turned about an axis of length 1.</summary>
    private static Vector3 Rotate(Vector3 v, Vector3 axis, double angle)
    {
        var (sin, cos) = Math.SinCos(angle);
        return cos * v + sin * (axis % v) + (1 - cos) * (axis * v) * axis;
    }
}
