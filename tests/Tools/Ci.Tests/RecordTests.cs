namespace RayCaster.Ci.Tests;

public class RecordTests
{
    [Fact]
    public void TheNearestCommitThatPassedSaysWhatFailedAtFirst()
    {
        using var folder = new TemporaryFolder();
        var record = new Record(folder["cache"]);
        Assert.Null(record.LastPassed(["c", "b", "a"]));
        Assert.Empty(record.FailedAtFirst(null));
        record.Write("a", ["T.Old"]);
        record.Write("b", ["T.Waits", "T.AlsoWaits"]);
        Assert.Equal("b", record.LastPassed(["c", "b", "a"]));
        Assert.Equal(["T.AlsoWaits", "T.Waits"], record.FailedAtFirst("b"));
    }

    [Fact]
    public void OldFilesAreDeleted()
    {
        using var folder = new TemporaryFolder();
        for (var i = 0; i < 60; i++) new Record(folder.Path).Write($"{i}", []);
        Assert.Equal(50, folder.Names.Count());
    }
}
