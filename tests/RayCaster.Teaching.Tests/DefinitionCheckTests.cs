namespace RayCaster.Teaching.Tests;

public sealed class DefinitionCheckTests
{
    private static readonly Camera camera = new(new(5, 0, 0), new(0, 0, 0)) { Width = 30, Height = 20 };

    [Fact]
    public void IfTheDefinitionFailsLikeTheFastWayItsFaultIsTold()
    {
        var check = new DefinitionCheck(new(camera, [new Model<Broken>(default)]), ..);
        Assert.Throws<NotSupportedException>(() => check.Watch(() => throw new InvalidOperationException("by code that has inlined the formula")));
    }

    [Fact]
    public void IfOnlyTheFastWayFailsItsFaultIsTold()
    {
        var check = new DefinitionCheck(new(camera, []), ..);
        Assert.Throws<IOException>(() => check.Watch(() => throw new IOException("the disk is full")));
    }

    private readonly record struct Broken : IPrimitive
    {
        public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => throw new NotSupportedException();
    }
}
