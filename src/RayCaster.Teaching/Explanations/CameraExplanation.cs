namespace RayCaster.Teaching;

internal static class CameraExplanation
{
    /// <summary>W, U, V, h and w, which are the same for all pixels.</summary>
    public static IReadOnlyList<FormulaStep> Axes(Camera camera)
    {
        var (P, T, up) = (Digits.Of(camera.Position), Digits.Of(camera.Target), Digits.Of(camera.Up));
        return
        [
            Vector("W", "−(T − P) normalised", $"−({T} − {P}) / {Digits.Of((camera.Target - camera.Position).Length)}", camera.W),
            Vector("U", "(up × W) normalised", $"{up} × {Digits.Of(camera.W)} / {Digits.Of((camera.Up % camera.W).Length)}", camera.U),
            Vector("V", "W × U", $"{Digits.Of(camera.W)} × {Digits.Of(camera.U)}", camera.V),
            new("h", "2 tan(fovY / 2)", $"2 · tan({Digits.Of(camera.FovY)}° / 2)", [camera.PlaneHeight]),
            new("w", "h · width / height", $"{Digits.Of(camera.PlaneHeight)} · {camera.Width} / {camera.Height}", [camera.PlaneWidth]),
        ];
    }

    /// <summary>The steps from the pixel to the direction of its ray.</summary>
    public static IReadOnlyList<FormulaStep> RaySteps(Camera camera, int column, int row)
    {
        var d = camera.Direction(((Derivation)column).As("c", ""), ((Derivation)row).As("r", ""));
        return FormulaStep.LeadingTo(d.X, d.Y, d.Z);
    }

    private static FormulaStep Vector(string name, string formula, string numbers, Vector3 v) => new(name, formula, numbers, [v.X, v.Y, v.Z]);
}
