namespace Lab.Tests;

/// <summary>Slide "Primitive Shading".</summary>
[Trait("step", "5")]
public class Step05Shading : StepTests
{
    private const string Slide = "Primitive Shading";

    private readonly Chance chance = new();

    private static double Red(RayCaster.Vector3 P, RayCaster.Vector3 T, double t, double red)
    {
        var camera = new Camera(RayAssert.Mine(P), RayAssert.Mine(T), new(0, 0, 1), 45, 1, 1);
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(red, 0, 0) };
        var ray = new Ray(camera.Position, new(-1, 0, 0)) { HitParameter = t, HitModel = model, DepthPerT = 0.5 }; // t, not z
        var untouched = new Untouched(("this", camera), ("ray", ray), ("ray.HitModel", model));
        var shaded = camera.Shade(ray).R;
        untouched.Check(Slide);
        return shaded;
    }

    [Fact]
    public void TheTargetHasHalfItsColour() => RayAssert.Equal("red at t = 20 of the target at 20", Slide, 0.5, Red(new(20, 0, 0), default, 20, 1));

    [Fact]
    public void FromTwiceTheTargetsDistanceOnAllIsBlack()
    {
        RayAssert.Equal("red at t = 40 of the target at 20", Slide, 0, Red(new(20, 0, 0), default, 40, 1));
        RayAssert.Equal("red at t = 50 of the target at 20, which is not less than 0", Slide, 0, Red(new(20, 0, 0), default, 50, 1));
    }

    [Fact]
    public void RandomHits()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (P, T, t, red) = (chance.Point(), chance.Point(), chance.Length(40), chance.Length(1));
            var expected = Math.Max(0, 1 - t / (2 * (T - P).Length)) * red;
            RayAssert.Equal(
                FormattableString.Invariant($"red of {red:0.####} at t = {t:0.####} for P = {RayAssert.Text(P)}, T = {RayAssert.Text(T)}"),
                Slide, expected, Red(P, T, t, red));
        }
    }

    [Fact]
    public void ThePixelShowsWhatShadeMakesOfTheHit()
    {
        var camera = new Camera(new(20, 0, 0), Vector3.Zero, new(0, 0, 1), 45, 10, 10);
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(1, 0, 0) };
        var shaded = camera.Shade(new(camera.Position, new(-1, 0, 0)) { HitParameter = 20, HitModel = model }).R;
        var scene = new Scene(camera, new(0, 0, 1)) { Models = { model } };
        var untouched = new Untouched(("Camera", camera), ("Models[0]", model));
        var red = scene.CastRay(5, 5).R;
        untouched.Check("Ray Casting");
        RayAssert.Equal("red of CastRay, which returns what Shade returns", "Ray Casting", shaded, red);
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(5, "plane", "room", "mistakes/generic");
}
