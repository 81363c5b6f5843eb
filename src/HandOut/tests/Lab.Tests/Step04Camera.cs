using RayCaster;

namespace Lab.Tests;

/// <summary>Slides "Camera", "Camera Pixel Translation", "Ray Casting".</summary>
[Trait("step", "4")]
public class Step04Camera : StepTests
{
    private const string Slide = "Camera", PixelSlide = "Camera Pixel Translation";

    private readonly Chance chance = new();

    [Fact]
    public void TheCoursesCameraLooksAlongTheXAxis()
    {
        var camera = new Camera(new(20, 0, 0), Vector3.Zero, new(0, 0, 1), 45, 500, 500);
        RayAssert.Equal("W", Slide, new(1, 0, 0), camera.W, isUnit: true);
        RayAssert.Equal("U", Slide, new(0, 1, 0), camera.U, isUnit: true);
        RayAssert.Equal("V", Slide, new(0, 0, 1), camera.V, isUnit: true);
        RayAssert.Equal("h for fovY = 45 (degrees)", Slide, 0.8284271247, camera.h);
        RayAssert.Equal("w for 500 x 500 pixels", Slide, 0.8284271247, camera.w);
        RayAssert.Equal("d through the middle of the picture", PixelSlide, new(-1, 0, 0), camera.Direction(250, 250), isUnit: true);
    }

    [Fact]
    public void ThePixelShowsTheNearestModelOrTheBackground()
    {
        var camera = new Camera(new(20, 0, 0), Vector3.Zero, new(0, 0, 1), 45, 10, 10);
        var scene = new Scene(camera, new(0, 0, 1));
        Assert.True(
            IsBackground(),
            $"a pixel of an empty world shows the background: a ray without a hit has no HitModel, it is null.\n  {RayAssert.Cite("Ray Casting")}");
        scene.Models.Add(new Plane(new(-5, 0, 0), new(1, 0, 0)) { Color = new(1, 0, 0) });
        scene.Models.Add(new Plane(new(5, 0, 0), new(1, 0, 0)) { Color = new(0, 1, 0) });
        scene.Models.Add(new Plane(new(-9, 0, 0), new(1, 0, 0)) { Color = new(1, 0, 0) });
        var ray = camera.RayThrough(5, 5);
        scene.Models[1].Intersect(ray);
        Assert.True(
            ray.HitModel == scene.Models[1],
            $"the ray through the middle of the picture hits no plane: let the tests of W, U, V, h, w and d pass first.\n  {RayAssert.Cite(Slide)}");
        var shown = scene.CastRay(5, 5).ToBytes();
        var wrong = shown == (0, 0, 255)
            ? "the ray to three planes has no hit, so the pixel shows the background: call Intersect of each model with the pixel's ray"
            : shown == camera.Shade(ray).ToBytes() ? null
            : "of three planes behind each other the nearest shows, not the first or the last, in the colour that Shade makes of its hit: " +
                "all models get the same ray";
        Assert.True(wrong == null, $"{wrong}.\n  {RayAssert.Cite("Ray Casting")}");

        bool IsBackground()
        {
            try { return scene.CastRay(5, 5).ToBytes() == (0, 0, 255); }
            catch (NullReferenceException) { return false; } // the colour of a HitModel that is null
        }
    }

    [Fact]
    public void TheRayIsThatOfThePixelsColumnAndRow()
    {
        var camera = new Camera(new(20, 0, 0), Vector3.Zero, new(0, 0, 1), 45, 10, 10);
        var floor = new Plane(new(0, 0, -1), new(0, 0, 1)) { Color = new(1, 0, 0) }; // in the rows below the middle
        var scene = new Scene(camera, new(0, 0, 1)) { Models = { floor } };
        foreach (var (c, r) in ((int, int)[])[(8, 2), (2, 8)])
        {
            var ray = camera.RayThrough(c, r);
            floor.Intersect(ray);
            var expected = ray.HitModel == floor ? "the floor" : "the background";
            var got = scene.CastRay(c, r).ToBytes() == (0, 0, 255) ? "the background" : "the floor"; // whatever its light is
            Assert.True(expected == got, $"CastRay(c = {c}, r = {r}): expected {expected}, but got {got}.\n  {RayAssert.Cite("Ray Casting")}");
        }
    }

    [Fact]
    public void RandomCameras()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (P, T, up) = (chance.Point(), chance.Point(), chance.Direction());
            if ((up % (T - P).Normalized).Length < 0.1) continue; // up may not lie along the view
            var (fovY, width, height) = (20 * chance.Length(8), (int)(100 * chance.Length()), (int)(100 * chance.Length()));
            var right = new RayCaster.Camera(P, T) { Up = up, FovY = fovY, Width = width, Height = height };
            var (position, target, upwards) = (RayAssert.Mine(P), RayAssert.Mine(T), RayAssert.Mine(up));
            var given = new Untouched(("Position", position), ("Target", target), ("Up", upwards));
            var mine = new Camera(position, target, upwards, fovY, width, height);
            given.Check(Slide);
            var which = FormattableString.Invariant(
                $"for P = {RayAssert.Text(P)}, T = {RayAssert.Text(T)}, up = {RayAssert.Text(up)}, fovY = {fovY:0.##}, {width} x {height} pixels");
            RayAssert.Equal($"W {which}", Slide, right.W, mine.W, isUnit: true);
            RayAssert.Equal($"U {which}", Slide, right.U, mine.U, isUnit: true);
            RayAssert.Equal($"V {which}", Slide, right.V, mine.V, isUnit: true);
            RayAssert.Equal($"h {which}", Slide, right.PlaneHeight, mine.h);
            RayAssert.Equal($"w {which}", Slide, right.PlaneWidth, mine.w);
            var (c, r) = (chance.Length() * width / 4, chance.Length() * height / 4);
            var d = right.Direction<Scalar>(c, r);
            var untouched = new Untouched(("this", mine));
            var myD = mine.Direction(c, r);
            untouched.Check(PixelSlide);
            RayAssert.Equal($"d for c = {RayAssert.Text(c)}, r = {RayAssert.Text(r)} {which}", PixelSlide, new(d.X, d.Y, d.Z), myD, isUnit: true);
        }
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(4, "plane", "room", "mistakes/generic");
}
