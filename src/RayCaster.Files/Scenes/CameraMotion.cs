namespace RayCaster.Files;

/// <summary>Moves a camera: turns it about its target, brings it nearer, or shifts it together with its target.</summary>
internal static class CameraMotion
{
    /// <summary>The least angle between the view and up, in radians. At 0 the picture would turn over.</summary>
    private const double LeastAngle = 0.01;

    /// <summary>A frame of a full turn about the target. Frame 0 has the camera itself, and so would the frame after the last.</summary>
    /// <param name="frames">How many frames make a full turn, counterclockwise seen from above.</param>
    public static Camera Orbit(Camera camera, int frame, int frames)
    {
        if (frame == 0) return camera;
        var turned = Rotate(camera.Position - camera.Target, camera.Up.Normalized, 2 * Math.PI * frame / frames);
        return camera with { Position = camera.Target + turned };
    }

    /// <param name="around">The angle about the up direction in radians, counterclockwise seen from above.</param>
    /// <param name="over">The angle towards up in radians; limited so that the view never becomes parallel to up.</param>
    public static Camera Turn(Camera camera, double around, double over)
    {
        var axis = camera.Up.Normalized;
        var v = camera.Position - camera.Target;
        var angle = Math.Acos(Math.Clamp(axis * v.Normalized, -1, 1)); // between up and the direction to the camera
        var to = Math.Clamp(angle - over, LeastAngle, Math.PI - LeastAngle);
        v = Rotate(v, camera.U, to - angle);
        return At(camera, camera.Target + Rotate(v, axis, around), camera.Target);
    }

    public static Camera Approach(Camera camera, double factor) =>
        At(camera, camera.Target + factor * (camera.Position - camera.Target), camera.Target);

    /// <summary>Shifts camera and target across the view. The unit is the picture's height at the target.</summary>
    public static Camera Shift(Camera camera, double right, double up)
    {
        var height = camera.PlaneHeight * (camera.Target - camera.Position).Length;
        var shift = right * height * camera.U + up * height * camera.V;
        return At(camera, camera.Position + shift, camera.Target + shift);
    }

    /// <summary>The same camera with coordinates that are easy to read: rounded to about a ten-thousandth of the distance from the target.</summary>
    public static Camera Rounded(Camera camera)
    {
        var distance = (camera.Target - camera.Position).Length;
        var digits = (int)Math.Clamp(4 - Math.Floor(Math.Log10(distance)), 0, 15);
        return At(camera, Round(camera.Position), Round(camera.Target));

        Vector3 Round(Vector3 v) => new(Math.Round(v.X, digits), Math.Round(v.Y, digits), Math.Round(v.Z, digits));
    }

    /// <summary>The camera at another place; the old one if no picture can be taken from there.</summary>
    private static Camera At(Camera camera, Vector3 position, Vector3 target)
    {
        var moved = camera with { Position = position, Target = target };
        return moved.ValidationError is null ? moved : camera;
    }

    /// <summary>Turns v about an axis of length 1 (Rodrigues' formula).</summary>
    private static Vector3 Rotate(Vector3 v, Vector3 axis, double angle)
    {
        var (sin, cos) = Math.SinCos(angle);
        return cos * v + sin * (axis % v) + (1 - cos) * (axis * v) * axis;
    }
}
