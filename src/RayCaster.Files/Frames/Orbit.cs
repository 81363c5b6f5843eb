namespace RayCaster.Files;

/// <summary>A camera that goes once around its target, about the direction that is up, and always looks at it.</summary>
public static class Orbit
{
    /// <summary>The camera of a frame; frame 0 is the scene's own, and the frame after the last would be it again.</summary>
    /// <param name="camera">The scene's camera.</param>
    /// <param name="frame">The frame, from 0.</param>
    /// <param name="frames">How many make a full turn, counterclockwise seen from above.</param>
    public static Camera Frame(Camera camera, int frame, int frames)
    {
        if (frame == 0) return camera;
        var axis = camera.Up.Normalized;
        var (sin, cos) = Math.SinCos(2 * Math.PI * frame / frames);
        var v = camera.Position - camera.Target;
        var turned = cos * v + sin * (axis % v) + (1 - cos) * (axis * v) * axis; // Rodrigues
        return new(camera.Parameters with { Position = camera.Target + turned });
    }
}
