namespace Lab.Tests;

/// <summary>Slide "Primitive Shading".</summary>
[Trait("step", "5")]
public class Step05Shading : StepTests
{
    private const string Slide = "Primitive Shading";

    private readonly Chance chance = new();

    /// <summary>Checks red, green and blue, which differ where the model's colour does.</summary>
    private static void AssertShade(string which, double attenuation, RayCaster.Vector3 P, RayCaster.Vector3 T, double t, RayCaster.Vector3 rgb)
    {
        var camera = new Camera(RayAssert.Mine(P), RayAssert.Mine(T), new(0, 0, 1), 45, 1, 1);
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(rgb.X, rgb.Y, rgb.Z) };
        var ray = new Ray(camera.Position, new(-1, 0, 0)) { HitParameter = t, HitModel = model, DepthPerT = 0.5 }; // t, not z
        var untouched = new Untouched(("this", camera), ("ray", ray), ("ray.HitModel", model));
        var shaded = camera.Shade(ray);
        untouched.Check(Slide);
        RayAssert.Equal($"red {which}", Slide, attenuation * rgb.X, shaded.R);
        RayAssert.Equal($"green {which}", Slide, attenuation * rgb.Y, shaded.G);
        RayAssert.Equal($"blue {which}", Slide, attenuation * rgb.Z, shaded.B);
    }

    [Fact]
    public void TheTargetHasHalfItsColour() => AssertShade("at t = 20 of the target at 20", 0.5, new(20, 0, 0), default, 20, new(1, 1, 1));

    [Fact]
    public void FromTwiceTheTargetsDistanceOnAllIsBlack()
    {
        AssertShade("at t = 40 of the target at 20", 0, new(20, 0, 0), default, 40, new(1, 1, 1));
        AssertShade("at t = 50 of the target at 20, which is not less than 0", 0, new(20, 0, 0), default, 50, new(1, 1, 1));
    }

    [Fact]
    public void RandomHits()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (P, T, t) = (chance.Point(), chance.Point(), chance.Length(40));
            var rgb = new RayCaster.Vector3(chance.Length(1), chance.Length(1), chance.Length(1));
            AssertShade($"of {RayAssert.Text(rgb)} at t = {RayAssert.Text(t)} for P = {RayAssert.Text(P)}, T = {RayAssert.Text(T)}",
                Math.Max(0, 1 - t / (2 * (T - P).Length)), P, T, t, rgb);
        }
    }

    [Fact]
    public void ThePixelShowsWhatShadeMakesOfTheHit()
    {
        var camera = new Camera(new(20, 0, 0), Vector3.Zero, new(0, 0, 1), 45, 10, 10);
        var model = new Plane(Vector3.Zero, new(1, 0, 0)) { Color = new(1, 0.8, 0.4) };
        var ray = camera.RayThrough(5, 5);
        model.Intersect(ray);
        var shaded = camera.Shade(ray).ToBytes();
        var scene = new Scene(camera, new(0, 0, 1)) { Models = { model } };
        var untouched = new Untouched(("Camera", camera), ("Models[0]", model));
        var shown = scene.CastRay(5, 5).ToBytes();
        untouched.Check("Ray Casting");
        Assert.True(shaded == shown, $"CastRay returns what Shade returns: expected {shaded}, but got {shown}.\n  {RayAssert.Cite("Ray Casting")}");
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(5, "plane", "room", "mistakes/generic");
}
