namespace RayCaster.Cli.Tests.Docs;

/// <summary>The program that README shows: scenes/first.json in C#.</summary>
internal static class SceneInCode
{
    public static void Run()
    {
        var camera = new Camera(position: new(6, 0, 2.5), target: new(-6, 0, 0)) { Width = 500, Height = 500 };
        Model[] models =
        [
            new Model<Plane>(new(Point: new(0, 0, 0), Normal: new(0, 0, 1))) { Color = new(127 / 255.0, 178 / 255.0, 217 / 255.0) },
            new Model<Sphere>(new(Center: new(0, 0, 1), Radius: 1)) { Color = new(1, 0.5, 0.1) },
        ];
        var picture = Renderer.Render(new Scene(camera, models));
        PictureFile.Write("first.png", picture);
    }
}
