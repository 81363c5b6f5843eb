namespace RayCaster.Files;

/// <summary>Where a moving camera is at one moment.</summary>
/// <param name="Time">The moment, in any unit: only the ratios of the times between keys matter.</param>
public readonly record struct CameraKey(double Time, Vector3 Position, Vector3 Target, double FovY);
