namespace RayCaster.Files;

/// <summary>Where a moving camera is at one moment.</summary>
/// <param name="Time">The moment, in any unit: only the ratios of the times between keys matter.</param>
public readonly record struct CameraKey(double Time, Vector3 Position, Vector3 Target, double FovY);

/// <summary>The path of a camera through two or more keys.</summary>
/// <param name="keys">The keys in the order of their times; no two times are equal.</param>
/// <param name="isSmooth">Whether the path is a curve through the keys (Catmull–Rom), or straight from each key to the next.</param>
public sealed class CameraPath(IReadOnlyList<CameraKey> keys, bool isSmooth)
{
    /// <summary>
    /// The camera of a frame. The first frame is at the first key's time, the last frame at the last key's, the others evenly between them. All
    /// but position, target and fovY is the scene camera's.
    /// </summary>
    public Camera Frame(Camera camera, int frame, int frames)
    {
        var (first, last) = (keys[0].Time, keys[^1].Time);
        var key = At(frame == 0 ? first : frame == frames - 1 ? last : first + (last - first) * frame / (frames - 1));
        return camera.With(position: key.Position, target: key.Target, fovY: key.FovY);
    }

    /// <summary>Where the camera is at a time from the first key's to the last one's.</summary>
    public CameraKey At(double time)
    {
        var i = 0;
        while (i < keys.Count - 2 && time >= keys[i + 1].Time) i++;
        var (from, to) = (keys[i], keys[i + 1]);
        var duration = to.Time - from.Time;
        var s = (time - from.Time) / duration;
        if (!isSmooth) return new(time, Mix(from.Position, to.Position), Mix(from.Target, to.Target), (1 - s) * from.FovY + s * to.FovY);

        // The cubic that has the keys' values and velocities at both ends (Hermite).
        var (atFrom, atTo) = (Velocity(i), Velocity(i + 1));
        var (a, b, c, d) = ((2 * s - 3) * s * s + 1, ((s - 2) * s + 1) * s * duration, (3 - 2 * s) * s * s, (s - 1) * s * s * duration);
        return new(time,
            a * from.Position + b * atFrom.Position + c * to.Position + d * atTo.Position,
            a * from.Target + b * atFrom.Target + c * to.Target + d * atTo.Target,
            a * from.FovY + b * atFrom.FovY + c * to.FovY + d * atTo.FovY);

        Vector3 Mix(Vector3 p, Vector3 q) => (1 - s) * p + s * q;
    }

    /// <summary>The change per time at a key: from the key before to the key after it, as in a Catmull–Rom curve; at an end, from or to the
    /// only neighbour.</summary>
    private CameraKey Velocity(int i)
    {
        var (before, behind) = (keys[Math.Max(i - 1, 0)], keys[Math.Min(i + 1, keys.Count - 1)]);
        var time = behind.Time - before.Time;
        return new(time, (behind.Position - before.Position) / time, (behind.Target - before.Target) / time, (behind.FovY - before.FovY) / time);
    }
}
