namespace RayCaster.Tests.Shapes;

/// <summary>A model that somebody adds in plain doubles and ifs.</summary>
public class CylinderTests
{
    [Fact]
    public void ItIsHitFromOutsideAndFromInside()
    {
        var tube = new Cylinder(Vector3.Zero, 2, 4);
        Assert.Equal(8, tube.Intersect(new Ray(new(10, 0, 1), new(-1, 0, 0))));
        Assert.Equal(2, tube.Intersect(new Ray(new(0, 0, 1), new(-1, 0, 0))));
        Assert.Null(tube.Intersect(new Ray(new(10, 0, 3), new(-1, 0, 0))));
        Assert.Null(tube.Intersect(new Ray(new(0, 0, 10), new(0, 0, -1))));
    }
}
