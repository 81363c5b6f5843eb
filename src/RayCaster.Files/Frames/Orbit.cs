namespace RayCaster.Files;

/// <summary>A camera that makes a full turn around its target, about the up direction.</summary>
public static class Orbit
{
    /// <summary>The camera of a frame. Frame 0 has the scene's camera, and so would the frame after the last.</summary>
    /// <param name="frames">How many frames make a full turn, counterclockwise seen from above.</param>
    public static Camera Frame(Camera camera, int frame, int frames)
    {
        if (frame == 0) return camera;
        var turned = CameraMotion.Rotate(camera.Position - camera.Target, camera.Up.Normalized, 2 * Math.PI * frame / frames);
        return new(camera.Parameters with { Position = camera.Target + turned });
    }
}
