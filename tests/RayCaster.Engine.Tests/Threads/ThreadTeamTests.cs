namespace RayCaster.Engine.Tests.Threads;

/// <summary>All pieces of the work are done, on any number of threads.</summary>
public class ThreadTeamTests
{
    [Theory]
    [InlineData(0, 3)]
    [InlineData(1, 3)]
    [InlineData(1000, 1)]
    [InlineData(1000, 2)]
    [InlineData(1000, 7)]
    public void EachPieceIsDoneOnce(int count, int threads)
    {
        for (var round = 0; round < 50; round++)
        {
            var times = new int[count];
            ThreadTeam.Each(count, threads, i => Interlocked.Increment(ref times[i]));
            Assert.All(times, done => Assert.Equal(1, done));
        }
    }

    [Fact]
    public void OneThreadDoesThemInOrder()
    {
        var order = new List<int>();
        ThreadTeam.Each(5, 1, order.Add);
        Assert.Equal([0, 1, 2, 3, 4], order);
    }

    [Fact]
    public void AnExceptionComesOutWhenTheOthersHaveEnded()
    {
        var (begun, running) = (0, 0);
        var thrown = Assert.Throws<FormatException>(() => ThreadTeam.Each(1000, 4, i =>
        {
            Interlocked.Increment(ref begun);
            Interlocked.Increment(ref running);
            Thread.Sleep(1);
            Interlocked.Decrement(ref running);
            if (i == 3) throw new FormatException("piece 3");
        }));
        Assert.Equal("piece 3", thrown.Message);
        Assert.Equal(0, running);
        Assert.InRange(begun, 4, 999);
    }

    [Fact]
    public void WorkInsideOfWorkEnds()
    {
        var done = 0;
        ThreadTeam.Each(8, 4, _ => ThreadTeam.Each(8, 4, _ => Interlocked.Increment(ref done)));
        Assert.Equal(64, done);
    }
}
