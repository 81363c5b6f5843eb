namespace RayCaster.Teaching.Tests.Hypotheses;

/// <summary>In pictures of something else no edit is found.</summary>
public class ForeignPictureTests
{
    [Fact(Explicit = true)]
    public void NoEditIsNamedForAForeignPicture() => AssertNoEditIsNamed("mistakes/portrait");

    [Theory(Explicit = true)]
    [Trait("runs", "weekly")]
    [InlineData("mistakes/generic")]
    [InlineData("mistakes/inside")]
    public void NorInOtherScenes(string name) => AssertNoEditIsNamed(name);

    private static void AssertNoEditIsNamed(string name)
    {
        var scene = SceneFolder.Small(name);
        var (camera, right) = (scene.Camera, Renderer.Render(scene));
        Picture[] foreign =
        [
            .. ((Camera[])
            [
                camera.With(position: camera.Position + new Vector3(0.37, 0.21, -0.13)),
                camera.With(target: camera.Target + new Vector3(0.7, -0.4, 0.5)),
                camera.With(fovY: 0.83 * camera.FovY),
                camera.With(up: new(0.2, 0.1, 0.9)),
            ]).Select(other => Renderer.Render(scene with { Camera = other })),
            Renderer.Render(scene with { Models = [.. scene.Models.Select(model => Colored(model, new(0.3, 0.8, 0.5)))] }),
            Picture.Create(right.Width, right.Height, (x, y) => Negative(right[x, y])),
            Picture.Create(right.Width, right.Height, (x, y) => Blurred(right, x, y)),
            Picture.Create(right.Width, right.Height, (x, y) => ((byte)(x * 7), (byte)(y * 5), (byte)(x * y))),
            Renderer.Render(SceneFolder.Small("room").WithSize(right.Width, right.Height)),
            Renderer.Render(SceneFolder.Small("weeks/4-all").WithSize(right.Width, right.Height)),
        ];
        var judge = new SceneDiagnosis(scene);
        Assert.All(foreign, picture => Assert.DoesNotContain(
            judge.Judge(picture).Suspects, suspect => suspect.Mistakes.Any(mistake => mistake.Place is not null)));
    }

    private static Model Colored(Model model, Color color) => model switch
    {
        Model<Sphere> { Primitive: var sphere } => new Model<Sphere>(sphere) { Color = color },
        _ => model,
    };

    private static (byte, byte, byte) Negative((byte R, byte G, byte B) color) =>
        ((byte)(255 - color.R), (byte)(255 - color.G), (byte)(255 - color.B));

    private static (byte, byte, byte) Blurred(Picture picture, int x, int y)
    {
        var (a, b) = (picture[x, y], picture[Math.Max(0, x - 1), Math.Max(0, y - 1)]);
        return ((byte)((a.R + b.R) / 2), (byte)((a.G + b.G) / 2), (byte)((a.B + b.B) / 2));
    }
}
