using System.Text;

namespace RayCaster.Files.Tests.Scenes;

/// <summary>A camera written into a scene changes its numbers and nothing else.</summary>
public class CameraEditTests
{
    private static readonly Camera camera = new(new(1.5, -2, 3), new(0, 0, 0.25));

    [Theory]
    [InlineData("{\"camera\":{\"position\":[6,0,2],\"target\":[0,0,0]}}", "{\"camera\":{\"position\":[1.5,-2,3],\"target\":[0,0,0.25]}}")]
    [InlineData("{ // c\n \"models\": [], \"camera\": { \"target\": [ /* x */ 0.0, 0e0, 1, ], // t\r\n\t\"position\":\n[6,\n 0,\n 2] } }",
        "{ // c\n \"models\": [], \"camera\": { \"target\": [ /* x */ 0.0, 0e0, 0.25, ], // t\r\n\t\"position\":\n[1.5,\n -2,\n 3] } }")]
    [InlineData(
        "\uFEFF{\"camera\":{\"position\":[6,0,2],\"target\":[0,0,0]}}", "\uFEFF{\"camera\":{\"position\":[1.5,-2,3],\"target\":[0,0,0.25]}}")]
    public void OnlyNumbersThatDifferChange(string before, string after) =>
        Assert.Equal(after, Encoding.UTF8.GetString(CameraEdit.Write(Encoding.UTF8.GetBytes(before), camera)));
}
