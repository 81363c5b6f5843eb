namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Scenes and colours of any size: floats reach from 1e-45 to 3e38. Beyond 1e±150 the definition's own squares overflow.</summary>
public class FloatRangeTests
{
    private static readonly int[] some = [-140, -46, -45, -38, -37, -19, 19, 38, 39, 100]; // where floats begin and end, and beyond

    public static IEnumerable<TheoryDataRow<int>> PowersOfTen =>
        ((int[])[.. some, -100, -60, -44, -42, -40, -39, -34, -31, -30, -29, -20, 20, 29, 30, 31, 34, 37, 40, 46, 60])
            .Select(power => new TheoryDataRow<int>(power) { Explicit = !some.Contains(power) });

    public static TheoryData<int> PowersOfColours => [-300, -200, -46, -45, -39, -38, -37, -30, 7, 30, 37, 38, 39, 46, 200, 300];

    /// <summary>Large enough for tiles and parts that one model covers.</summary>
    [Theory]
    [MemberData(nameof(PowersOfTen))]
    public void ASceneOfAnySizeComesOutToTheBit(int power)
    {
        var unit = Math.Pow(10, power);
        foreach (var (models, clip) in new[] { (0, ClipMode.Depth), (0, ClipMode.Distance), (90, ClipMode.Distance) })
            RendererTests.AssertEqual(SceneOf(unit, models, clip, new Color(1, 0.5, 0.25)), $"1e{power}, {models} small models");
    }

    [Theory]
    [MemberData(nameof(PowersOfColours))]
    public void AColourOfAnySizeComesOutToTheBit(int power)
    {
        foreach (var models in new[] { 0, 90 })
            RendererTests.AssertEqual(SceneOf(1, models, ClipMode.Depth, Math.Pow(10, power) * new Color(1, 0.5, 0)), $"a colour of 1e{power}");
    }

    /// <summary>Alone in its tiles a mesh has a painter of its own.</summary>
    [Theory]
    [MemberData(nameof(PowersOfTen))]
    public void AMeshOfAnySizeComesOutToTheBit(int power)
    {
        var (unit, ball) = (Math.Pow(10, power), MeshGenerator.BumpySphere(2));
        var camera = new Camera(unit * new Vector3(2, 0.5, 1), Vector3.Zero) { Width = 128, Height = 70, ZNear = 0, ZFar = 100 * unit, Bias = 0 };
        var mesh = new Mesh([.. ball.Vertices.Select(p => unit * p)], ball.Indices);
        RendererTests.AssertEqual(new(camera, [mesh], new Color(0.1, 0.2, 0.3)), $"1e{power}");
    }

    private static Scene SceneOf(double unit, int smallModels, ClipMode clip, Color color)
    {
        var random = new Random(smallModels);
        Vector3 At(double x, double y, double z) => unit * new Vector3(x, y, z);
        var models = new List<Model>
        {
            Model.Of(new Plane(At(0, 0, -2), new(0.1, 0.2, 1))),
            Model.Of(new Plane(At(-9, 0, 0), new(1, 0.1, 0.1))),
            Model.Of(new Sphere(At(0, -1, 0), unit)),
            Model.Of(new Aabb(At(-1, 0.2, -1), At(0.5, 2, 0.3))),
            Model.Of(new Circle(At(1, 0, 1), new(1, 0.2, 0.3), 0.7 * unit)),
            Model.Of(new Triangle(At(1, 1, 1), At(1, 2, 1), At(0, 1.5, 2))),
        };
        for (var i = 0; i < smallModels; i++)
        {
            var center = unit * (2 * Some.Point(random, 1));
            models.Add((i % 3) switch
            {
                0 => Model.Of(new Aabb(center, center + unit * new Vector3(0.1, 0.2, 0.1))),
                1 => Model.Of(new Triangle(center, center + unit * Some.Point(random, 0.3), center + unit * Some.Point(random, 0.3))),
                _ => Model.Of(new Sphere(center, 0.1 * unit)),
            });
        }
        foreach (var model in models) model.Color = color;
        return new(
            new Camera(At(5, 0.5, 1), Vector3.Zero) { Width = 128, Height = 80, ZNear = 0, ZFar = 12 * unit, Bias = 1e-6 * unit, Clip = clip },
            models, new Color(0.1, 0.2, 0.3));
    }
}
