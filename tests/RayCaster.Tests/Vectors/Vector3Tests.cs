namespace RayCaster.Tests.Vectors;

public class Vector3Tests
{
    [Theory]
    [InlineData(3e-200, 4e-200, 5e-200)]
    [InlineData(3e200, -4e200, 5e200)]
    [InlineData(0, -2, 2)]
    [InlineData(0, 0, 0)]
    public void LengthSurvivesSquaresThatLeaveTheRangeOfADouble(double x, double y, double length) =>
        Assert.InRange(new Vector3(0, x, y).Length, length * (1 - 1e-15), length * (1 + 1e-15));

    [Fact]
    public void InAFormulaNumbersAndVectorsArePrintedAsInASceneFile()
    {
        Vector3<Scalar> L = new Vector3(0.5, -2, 1);
        Assert.Equal("L = [0.5, -2, 1], L * L = 5.25", $"L = {L}, L * L = {L * L}");
    }

    [Fact]
    public void InAFormulaVectorsHaveTheOperatorsOfTheSlides()
    {
        Vector3<Scalar> a = new Vector3(1, 2, 3), b = new Vector3(-2, 0.5, 4);
        Assert.Equal("[6.5, -10, 4.5], [-1, -2, -3], [2, 4, 6]", $"{a % b}, {-a}, {a * 2.0}");
    }
}
